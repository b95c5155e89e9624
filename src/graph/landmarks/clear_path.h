#pragma once

#include <pcl/manifold/graph_voronoi.h>

namespace pcl {
namespace manifold {

/** Sets which contacts are adjacent by AdjacencyRule::CLEAR_PATH: those whose landmarks are joined by a path
 * of which every vertex and all neighbours of it lie in one of both tiles. Parallel in the current arena. */
void findClearPaths (const NeighborhoodGraph& graph, const std::vector<pcl::index_t>& landmarks,
                     const std::vector<pcl::index_t>& tiles, std::vector<TileContact>& contacts);

} // namespace manifold
} // namespace pcl
