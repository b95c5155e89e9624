#include "files/input_file.h"

#include "files/file_error.h"
#include "files/formats.h"

#include <boost/interprocess/file_mapping.hpp>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <system_error>

namespace pcl::manifold {

std::string
fileType (const std::string& file)
{
  std::string type = std::filesystem::path (file).extension ().string ();
  std::transform (type.begin (), type.end (), type.begin (),
                  [] (char c) { return c >= 'A' && c <= 'Z' ? static_cast<char> (c - 'A' + 'a') : c; });
  return type;
}

InputFile::InputFile (const std::string& name)
{
  namespace fs = std::filesystem;
  namespace bi = boost::interprocess;
  std::error_code error;
  const fs::file_status status = fs::status (name, error);
  if (!fs::exists (status))
    throw FileError ("cannot be read: " + std::generic_category ().message (error ? error.value () : ENOENT));
  if (!fs::is_regular_file (status))
    throw FileError (fs::is_directory (status) ? "cannot be read: it is a folder"
                                               : "cannot be read: it is no regular file");
  // Opened once for the system's own word on why not: Boost reports a number.
  const std::unique_ptr<std::FILE, int (*) (std::FILE*)> probe (std::fopen (name.c_str (), "rb"),
                                                                &std::fclose);
  if (!probe)
    throw FileError ("cannot be read: " + std::generic_category ().message (errno));
  if (fs::file_size (name, error) == 0 || error)
    return; // an empty file cannot be mapped
  try {
    const bi::file_mapping mapping (name.c_str (), bi::read_only);
    region_ = bi::mapped_region (mapping, bi::read_only);
  } catch (const bi::interprocess_exception& exception) {
    throw FileError (std::string ("cannot be read: ") + exception.what ());
  }
}

} // namespace pcl::manifold
