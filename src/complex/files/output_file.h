#pragma once

#include <cstddef>
#include <cstdio>
#include <string>
#include <string_view>

namespace pcl {
namespace manifold {

/** \brief A file that appears complete or not at all: it is written under another name in the same folder and
 * renamed by commit (). Without commit () nothing is left of it, and what was there before stays. */
class OutputFile
{
public:
  /** \throw FileError if the file cannot be created, or something other than a regular file has its name */
  explicit OutputFile (const std::string& name);

  ~OutputFile ();

  OutputFile (const OutputFile&) = delete;
  OutputFile& operator= (const OutputFile&) = delete;

  /** \throw FileError if the disk is full or fails */
  void write (std::string_view bytes);

  /** \brief Finish and give the file its name.
   * \throw FileError if the disk is full or fails */
  void commit ();

private:
  std::string name_;      ///< of the file that is replaced, links followed
  std::string part_name_; ///< while it is written; empty once it is gone
  std::FILE* part_ = nullptr;
};

/** \brief Where a file with this name would be written, links followed.
 * \throw FileError if a folder or another special file has that name, or its folder does not exist */
std::string resolveOutput (const std::string& name);

} // namespace manifold
} // namespace pcl
