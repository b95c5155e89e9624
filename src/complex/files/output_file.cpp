#include "complex/files/output_file.h"

#include "complex/files/file_error.h"

#include <cerrno>
#include <filesystem>
#include <system_error>

namespace pcl {
namespace manifold {

namespace {

[[noreturn]] void
failWriting (int error)
{
  throw FileError ("cannot be written: " + std::generic_category ().message (error));
}

} // namespace

std::string
resolveOutput (const std::string& name)
{
  namespace fs = std::filesystem;
  std::error_code error;
  fs::path path = name;
  constexpr int most_links = 40; // as the system itself allows
  for (int i = 0; i < most_links && fs::is_symlink (path, error); ++i)
    path = path.parent_path () / fs::read_symlink (path, error);
  const fs::file_status status = fs::status (path, error);
  if (fs::exists (status) && !fs::is_regular_file (status))
    throw FileError (fs::is_directory (status) ? "cannot be written: it is a folder"
                                               : "cannot be written: it is no regular file");
  const fs::path folder = path.has_parent_path () ? path.parent_path () : fs::path (".");
  if (!fs::is_directory (folder, error))
    throw FileError ("cannot be written: there is no folder " + folder.string ());
  return path.string ();
}

OutputFile::OutputFile (const std::string& name) : name_ (resolveOutput (name))
{
  // Created exclusively, so that two programs never write to one part file.
  for (int i = 0; i < 1000 && part_ == nullptr; ++i) {
    part_name_ = name_ + "." + std::to_string (i) + ".part";
    part_ = std::fopen (part_name_.c_str (), "wbx");
    if (part_ == nullptr && errno != EEXIST)
      break;
  }
  if (part_ == nullptr)
    failWriting (errno);
}

OutputFile::~OutputFile ()
{
  if (part_ != nullptr)
    std::fclose (part_);
  if (!part_name_.empty ())
    std::remove (part_name_.c_str ());
}

void
OutputFile::write (std::string_view bytes)
{
  if (std::fwrite (bytes.data (), 1, bytes.size (), part_) != bytes.size ())
    failWriting (errno);
}

void
OutputFile::commit ()
{
  // A full disk may show only here, when the last bytes leave the buffer.
  const bool flushed = std::fflush (part_) == 0 && std::ferror (part_) == 0;
  const int flush_error = errno;
  const bool closed = std::fclose (part_) == 0;
  const int close_error = errno;
  part_ = nullptr;
  if (!flushed || !closed)
    failWriting (flushed ? close_error : flush_error);
  if (std::rename (part_name_.c_str (), name_.c_str ()) != 0)
    failWriting (errno);
  part_name_.clear ();
}

} // namespace manifold
} // namespace pcl
