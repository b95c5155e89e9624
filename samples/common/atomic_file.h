#pragma once

#include <functional>
#include <string>

namespace pcl::manifold::apps {

/** \brief A file that appears complete or not at all: it is written under a temporary name in the same folder
 * and renamed at the end. Unless committed, it is removed. */
class AtomicFile
{
public:
  /** \brief Makes the temporary file, empty.
   * \throws AppError if the folder is missing or not writable, or `file` is a folder, a device, or a file
   * that may not be written */
  explicit AtomicFile (const std::string& file);

  AtomicFile (const AtomicFile&) = delete;
  AtomicFile& operator= (const AtomicFile&) = delete;

  ~AtomicFile ();

  /** \brief The name to write to; it has the same extension. */
  const std::string& temporaryName () const { return temporary_; }

  /** \brief Makes sure that what was written is on the disk, and gives it its name.
   * \throws AppError if that fails; the temporary file is removed then */
  void commit ();

private:
  std::string file_;
  std::string target_;
  std::string temporary_;
};

/** \brief Writes a file through AtomicFile.
 * \param[in] write is given the temporary name; to fail, it throws
 * \throws AppError about `file` if that name cannot be made, and whatever `write` throws; nothing is left
 * then */
void writeAtomically (const std::string& file, const std::function<void (const std::string&)>& write);

/** \brief Finds out early whether `file` could be written, by making and removing a temporary file beside it.
 * \throws AppError if not */
void checkWritable (const std::string& file);

} // namespace pcl::manifold::apps
