#pragma once

#include <cstdio>
#include <string>
#include <string_view>

namespace pcl::manifold {

/** \brief A file that appears complete or not at all: it is written under another name in the same folder and
 * renamed by commit (). Without commit () nothing is left of it, and what was there before stays. A file that
 * is replaced must be writable and keeps its mode; behind a symbolic link, the file that it leads to is
 * replaced and not the link. */
class OutputFile
{
public:
  /** \throw FileError if the file cannot be created or replaced, or something other than a regular file has
   * its name */
  explicit OutputFile (const std::string& name);

  ~OutputFile ();

  OutputFile (const OutputFile&) = delete;
  OutputFile& operator= (const OutputFile&) = delete;

  /** \throw FileError if the disk is full or fails */
  void write (std::string_view bytes);

  /** \brief Make sure that all bytes are on the disk, and give the file its name.
   * \throw FileError if the disk is full or fails */
  void commit ();

private:
  /** \brief Creates the part file, empty, in the folder of name_. */
  void createPart ();

  std::string name_;      ///< of the file that is replaced, links followed
  std::string part_name_; ///< while it is written; empty once it is gone
  std::FILE* part_ = nullptr;
};

} // namespace pcl::manifold
