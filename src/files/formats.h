#pragma once

#include "files/cloud_fields.h"
#include "files/output_file.h"

#include <pcl/manifold/simplicial_complex.h>
#include <pcl/manifold/topology_report.h>

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace pcl::manifold {

/** \brief Where a sensor stood and how it was turned: translation and quaternion (w, x, y, z). */
using Viewpoint = std::array<double, 7>;

/** \brief What is read from a file. */
struct FileContent
{
  pcl::PCLPointCloud2 cloud;
  SimplicialComplex complex;
  Viewpoint viewpoint{0, 0, 0, 1, 0, 0, 0}; ///< of a PCD file, or a PLY file of PCL
  std::vector<std::string> notes;           ///< lines that the user should be told: what was left out
};

/** \brief What is written to a file. All indices are those of points. */
struct FileCells
{
  const SimplicialComplex& complex;
  const FaceRows& polygons; ///< further faces
};

/** \brief The end of a file's name from its last dot on, in lower case; empty if there is none. */
std::string fileType (const std::string& file);

// All of these throw FileError. The readers get the bytes of the whole file; the writers valid cells.

FileContent readPly (std::string_view bytes);

/** \brief Reads OBJ. Colours in the `v` lines become a field rgb, normals normal_x, normal_y and normal_z where
 * there is one a point; a note says what is left out. */
FileContent readObj (std::string_view bytes);

/** \brief Reads PCD, of text, binary or compressed data, with every field but padding. */
FileContent readPcd (std::string_view bytes);

/** \brief Reads the vertices of OFF in text (OFF, COFF, NOFF and the like), as FLOAT64. What else a vertex
 * carries, and the faces, are not read. */
FileContent readOff (std::string_view bytes);

/** \brief Reads points from text, one a line: three numbers or more.
 *
 * They are separated by semicolons, commas or white space, one of these in all of the file; where commas do
 * not separate they are taken for decimal points. The commonest number of columns is that of the points.
 * Lines that begin with `#`, `//` or `%` are comments, and so is what follows a `#`. Lines ahead of the
 * points are skipped, others too as long as they are a few; notes tell which. A line ahead of the points, or
 * a comment, with one name a column names the fields: x, y and z wherever they are; without these three names
 * the first three columns are the coordinates. Fields without a name are column_4, column_5 and so on. All
 * are FLOAT64. \throw FileError with the line of what contradicts the rest or is skipped once too often */
FileContent readText (std::string_view bytes);

void writePly (OutputFile& file, const CloudFields& cloud, const FileCells& cells, bool ascii);

void writeObj (OutputFile& file, const CloudFields& cloud, const FileCells& cells, bool ascii);

void writeVtk (OutputFile& file, const CloudFields& cloud, const FileCells& cells, bool ascii);

void writeVtu (OutputFile& file, const CloudFields& cloud, const FileCells& cells, bool ascii);

/** \brief Writes a cloud as a binary PCD file, every field bit for bit, padding left out. */
void writePcd (OutputFile& file, const pcl::PCLPointCloud2& cloud, const Viewpoint& viewpoint);

} // namespace pcl::manifold
