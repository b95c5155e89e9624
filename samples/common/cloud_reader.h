#pragma once

#include <pcl/PCLPointCloud2.h>

#include <array>
#include <string>
#include <vector>

namespace pcl::manifold::apps {

/** \brief A cloud read from a file. */
struct InputCloud
{
  std::string file;
  pcl::PCLPointCloud2 cloud;      ///< every field of the file; x, y, z are FLOAT32; at least one point
  std::array<double, 3> origin{}; ///< was subtracted from the coordinates of the file
  std::size_t no_measurement = 0; ///< points that were none, and are NaN, see makeCoordinatesFloat ()
  std::array<double, 7> viewpoint{0, 0, 0, 1,
                                  0, 0, 0}; ///< of a PCD file: translation, quaternion (w, x, y, z)
  std::vector<std::string> notes;           ///< lines that the user should be told

  std::size_t size () const { return static_cast<std::size_t> (cloud.width) * cloud.height; }
};

/** \brief What is taken for a cloud. */
enum class Reading
{
  STRICT, ///< a file as its name says
  LAX     ///< a PLY file without a header too: text with a point a line, as in .xyz files
};

/** \brief Reads a cloud from a file whose name ends in one of the cloud_file_types; of a mesh, its vertices.
 * As PCL does it, fields `nx ny nz` become `normal_x normal_y normal_z`. Points may be NaN; the coordinates
 * are as makeCoordinatesFloat () leaves them.
 * \throws AppError that says what is wrong with the file, and where */
InputCloud readCloud (const std::string& file, Reading reading = Reading::STRICT);

/** \brief The file types that readCloud () takes, for help texts. */
extern const char* const cloud_file_types;

} // namespace pcl::manifold::apps
