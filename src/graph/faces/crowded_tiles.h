#pragma once

#include <pcl/manifold/graph_faces.h>

#include <vector>

namespace pcl {
namespace manifold {

/** The landmarks, ascending, of faces that pass one of them twice, or that no diagonals cut into triangles
 * but such as are edges of the mesh already: those go around something that is as thin as a tile. */
std::vector<pcl::index_t> crowdedTiles (const LandmarkMesh& mesh);

} // namespace manifold
} // namespace pcl
