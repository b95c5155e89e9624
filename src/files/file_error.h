#pragma once

#include <stdexcept>

namespace pcl::manifold {

/** \brief A file cannot be read or written; what () is one line that says why and where in the file. */
class FileError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

} // namespace pcl::manifold
