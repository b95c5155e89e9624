#pragma once

#include "app_error.h"

#include "files/file_error.h"
#include "files/formats.h"

#include <initializer_list>
#include <string>
#include <string_view>

namespace pcl::manifold::apps {

/** \brief Calls what reads or writes a file, and gives its failures the file's name.
 * \throws AppError instead of FileError */
template <typename Call>
auto
about (const std::string& file, const Call& call)
{
  try {
    return call ();
  } catch (const FileError& error) {
    throw AppError (file, error.what ());
  }
}

/** \brief Finds out early whether `file` could be written, by making and removing a file beside it.
 * \throws AppError if not */
void checkWritable (const std::string& file);

/** \brief Writes a file, complete or not at all.
 * \throws AppError that gives the reason, a full disk for example; an older file of that name stays then */
void writeFile (const std::string& file, std::string_view bytes);

/** \brief Writes a cloud as a binary PCD file, every field bit for bit, padding left out, complete or not at all.
 * \param[in] viewpoint translation and quaternion (w, x, y, z) of the sensor
 * \throws AppError if it cannot be written; an older file of that name stays then */
void writePcd (const std::string& file, const pcl::PCLPointCloud2& cloud,
               const Viewpoint& viewpoint = {0, 0, 0, 1, 0, 0, 0});

/** \brief Checks the name of a file that the user gave.
 * \param[in] argument what the user gave it as: OUTPUT, -picture
 * \param[in] file its name
 * \param[in] types what it may end in, such as ".pcd"
 * \throws UsageError if it ends in none of them */
void requireType (const std::string& argument, const std::string& file,
                  std::initializer_list<std::string> types);

} // namespace pcl::manifold::apps
