#pragma once

#include <pcl/manifold/graph_faces.h>

namespace pcl {
namespace manifold {

/** FaceRule::SHORTEST_CYCLES: takes the cycles of three adjacent tiles in lexicographic order, then those of
 * four, and so on up to a maximum length, whose edges are all in fewer than two cycles before.
 *
 * A cycle is known by the order that begins at its smallest tile and goes on to the smaller of its
 * neighbours. Nothing else decides, so that the result is the same on any machine. */
LandmarkMesh shortestCycles (std::size_t landmarks, const std::vector<TileContact>& contacts,
                             int maximum_length);

} // namespace manifold
} // namespace pcl
