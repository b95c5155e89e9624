#pragma once

#include <boost/interprocess/mapped_region.hpp>

#include <string>
#include <string_view>

namespace pcl::manifold {

/** \brief A file's bytes, mapped into memory and not copied. */
class InputFile
{
public:
  /** \throw FileError if the file cannot be read or is no regular file */
  explicit InputFile (const std::string& name);

  /** \brief All bytes of the file; valid as long as this object. */
  std::string_view bytes () const
  {
    return {static_cast<const char*> (region_.get_address ()), region_.get_size ()};
  }

private:
  boost::interprocess::mapped_region region_;
};

} // namespace pcl::manifold
