#pragma once

#include "complex/files/cloud_fields.h"
#include "complex/files/output_file.h"

#include <pcl/manifold/simplicial_complex.h>
#include <pcl/manifold/topology_report.h>

#include <string_view>

namespace pcl {
namespace manifold {

/** \brief What is read from a file. */
struct FileContent
{
  pcl::PCLPointCloud2 cloud;
  SimplicialComplex complex;
};

/** \brief What is written to a file. All indices are those of points. */
struct FileCells
{
  const SimplicialComplex& complex;
  const FaceRows& polygons; ///< further faces
};

// All of these throw FileError. The readers get the bytes of the whole file; the writers valid cells.

FileContent readPly (std::string_view bytes);

FileContent readObj (std::string_view bytes);

FileContent readVtk (std::string_view bytes);

FileContent readVtu (std::string_view bytes);

void writePly (OutputFile& file, const CloudFields& cloud, const FileCells& cells, bool ascii);

void writeObj (OutputFile& file, const CloudFields& cloud, const FileCells& cells, bool ascii);

void writeVtk (OutputFile& file, const CloudFields& cloud, const FileCells& cells, bool ascii);

void writeVtu (OutputFile& file, const CloudFields& cloud, const FileCells& cells, bool ascii);

} // namespace manifold
} // namespace pcl
