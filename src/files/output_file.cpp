#include "files/output_file.h"

#include "files/file_error.h"

#include <cerrno>
#include <filesystem>
#include <system_error>

#include <unistd.h>

namespace pcl::manifold {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void
fail (const std::string& why)
{
  throw FileError ("cannot be written: " + why);
}

[[noreturn]] void
fail (int error)
{
  fail (std::generic_category ().message (error));
}

/** \brief Where a file with this name is, links followed, also those to nothing. */
fs::path
followLinks (fs::path path)
{
  std::error_code error;
  constexpr int most_links = 40; // as the system itself allows
  for (int i = 0; i < most_links && fs::is_symlink (path, error); ++i)
    path = path.parent_path () / fs::read_symlink (path, error);
  return path;
}

/** \brief Fails unless a file that exists could be written in place. Replacing it would need no such right,
 * but it is protected for a reason. */
void
checkWritable (const std::string& name)
{
  std::FILE* const file = std::fopen (name.c_str (), "r+b");
  if (file == nullptr)
    fail (errno);
  std::fclose (file);
}

} // namespace

OutputFile::OutputFile (const std::string& name)
{
  const fs::path path = followLinks (name);
  std::error_code error;
  const fs::file_status status = fs::status (path, error);
  if (fs::is_directory (status) || !path.has_filename ())
    fail (std::string ("it is a folder"));
  if (fs::exists (status) && !fs::is_regular_file (status))
    fail (std::string ("it is no regular file"));
  const fs::path folder = path.has_parent_path () ? path.parent_path () : fs::path (".");
  if (!fs::is_directory (folder, error))
    fail ("there is no folder " + folder.string ());
  name_ = path.string ();
  if (fs::exists (status))
    checkWritable (name_);
  createPart ();
  error.clear ();
  if (fs::exists (status))
    fs::permissions (part_name_, status.permissions (), error);
  if (error) {
    std::fclose (part_);
    std::remove (part_name_.c_str ());
    fail (error.value ());
  }
}

OutputFile::~OutputFile ()
{
  if (part_ != nullptr)
    std::fclose (part_);
  if (!part_name_.empty ())
    std::remove (part_name_.c_str ());
}

void
OutputFile::createPart ()
{
  const fs::path path = name_;
  // Hidden, and short enough where the name itself is as long as names can be. Created exclusively, so that
  // two programs never write to one part file.
  const fs::path start = path.parent_path () / ("." + path.filename ().string ().substr (0, 100) + ".");
  for (int i = 0; i < 1000 && part_ == nullptr; ++i) {
    part_name_ = start.string () + std::to_string (i) + ".part";
    part_ = std::fopen (part_name_.c_str (), "wbx");
    if (part_ == nullptr && errno != EEXIST)
      break;
  }
  if (part_ == nullptr)
    fail (errno);
}

void
OutputFile::write (std::string_view bytes)
{
  if (std::fwrite (bytes.data (), 1, bytes.size (), part_) != bytes.size ())
    fail (errno);
}

void
OutputFile::commit ()
{
  // A full disk may show only here, when the last bytes leave the buffers.
  const bool stored = std::fflush (part_) == 0 && fsync (fileno (part_)) == 0;
  const int store_error = errno;
  const bool closed = std::fclose (part_) == 0;
  part_ = nullptr;
  if (!stored || !closed)
    fail (stored ? errno : store_error);
  if (std::rename (part_name_.c_str (), name_.c_str ()) != 0)
    fail (errno);
  part_name_.clear ();
}

} // namespace pcl::manifold
