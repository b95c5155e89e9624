#include "atomic_file.h"

#include "app_error.h"

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace pcl::manifold::apps {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void
failWithErrno (const std::string& file, const std::string& what)
{
  throw AppError (file, what + ": " + std::generic_category ().message (errno));
}

/** \brief The mode that a file of that name has, or would get when made the plain way. */
mode_t
modeFor (const std::string& target)
{
  struct stat status = {};
  if (stat (target.c_str (), &status) == 0)
    return status.st_mode & 07777;
  const mode_t mask = umask (0);
  umask (mask);
  return 0666 & ~mask;
}

} // namespace

AtomicFile::AtomicFile (const std::string& file) : file_ (file)
{
  // Behind a symbolic link, the file that it points to is replaced, not the link.
  std::error_code failure;
  const fs::path resolved = fs::weakly_canonical (file, failure);
  const fs::path target = failure ? fs::path (file) : resolved;
  const fs::file_status status = fs::status (target, failure);
  if (file.empty () || target.filename ().empty () || fs::is_directory (status))
    throw AppError (file, "is a folder, not a file");
  if (fs::exists (status) && !fs::is_regular_file (status))
    throw AppError (file, "is not a regular file");
  if (fs::exists (status) && access (target.c_str (), W_OK) != 0)
    failWithErrno (file, "cannot be written");
  const fs::path folder = target.has_parent_path () ? target.parent_path () : fs::path (".");
  const fs::file_status folder_status = fs::status (folder, failure);
  if (!fs::exists (folder_status))
    throw AppError (file, "there is no folder '" + folder.string () + "'");
  if (!fs::is_directory (folder_status))
    throw AppError (file, "'" + folder.string () + "' is not a folder");

  target_ = target.string ();
  const std::string extension = target.extension ().string ();
  temporary_ = (folder / ("." + target.stem ().string ().substr (0, 100) + ".XXXXXX" + extension)).string ();
  const int descriptor = mkstemps (temporary_.data (), static_cast<int> (extension.size ()));
  if (descriptor < 0)
    failWithErrno (file, "cannot be written");
  const bool usable = fchmod (descriptor, modeFor (target_)) == 0;
  close (descriptor);
  if (!usable) {
    const int reason = errno;
    unlink (temporary_.c_str ());
    errno = reason;
    failWithErrno (file, "cannot be written");
  }
}

AtomicFile::~AtomicFile ()
{
  if (!temporary_.empty ())
    unlink (temporary_.c_str ());
}

void
AtomicFile::commit ()
{
  // A disk may turn out to be full only when the data reaches it.
  const int descriptor = open (temporary_.c_str (), O_RDWR | O_CLOEXEC);
  if (descriptor < 0 || fsync (descriptor) != 0) {
    const int reason = errno;
    if (descriptor >= 0)
      close (descriptor);
    errno = reason;
    failWithErrno (file_, "cannot be written");
  }
  close (descriptor);
  if (rename (temporary_.c_str (), target_.c_str ()) != 0)
    failWithErrno (file_, "cannot be written");
  temporary_.clear ();
}

void
writeAtomically (const std::string& file, const std::function<void (const std::string&)>& write)
{
  AtomicFile output (file);
  write (output.temporaryName ());
  output.commit ();
}

void
checkWritable (const std::string& file)
{
  AtomicFile (file).temporaryName ();
}

} // namespace pcl::manifold::apps
