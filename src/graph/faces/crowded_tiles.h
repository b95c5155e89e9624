#pragma once

#include <pcl/manifold/graph_faces.h>

#include <vector>

namespace pcl {
namespace manifold {

/** The landmarks, ascending, whose tiles are crowded: too large for the thin part of the surface that they
 * are on, so that the mesh is no simplicial complex there. They are those of faces that pass a landmark
 * twice, or that no diagonals cut into triangles but such as are edges of the mesh already. */
std::vector<pcl::index_t> crowdedTiles (const LandmarkMesh& mesh);

} // namespace manifold
} // namespace pcl
