#pragma once

#include "cloud_reader.h"

#include <pcl/PCLPointCloud2.h>
#include <pcl/manifold/simplicial_complex.h>

#include <string>

namespace pcl::manifold::apps {

/** \brief A mesh read from a file. */
struct InputMesh
{
  pcl::PCLPointCloud2 cloud; ///< x, y and z are FLOAT32
  pcl::SimplicialComplex complex;
};

/** \brief Reads a mesh for a cloud: its coordinates become those that the cloud has after readCloud (). Where
 * they are as large as map coordinates the cloud's origin is subtracted from them; otherwise they are left as
 * they are, as in the meshes that the apps write.
 * \param[in] file ends in one of the mesh_file_types
 * \throws AppError that says what is wrong with the file: among that a mesh without faces, and a point of a
 * face that is not finite */
InputMesh readMesh (const std::string& file, const InputCloud& cloud);

/** \brief The file types that readMesh () takes, for help texts. */
extern const char* const mesh_file_types;

} // namespace pcl::manifold::apps
