#pragma once

#include <pcl/manifold/neighborhood_graph.h>

#include <cstdint>
#include <vector>

namespace pcl {
namespace manifold {

/** \brief A maximal k-hop stable set of a graph: no two of its vertices are nearer than k hops, and no vertex
 * could be added (section 3.1, "Independent set").
 *
 * It is the one that the greedy algorithm finds when it takes the vertices by a priority, a hash of the
 * vertex and the seed (ties: the smaller vertex): so it is the same for any number of threads.
 * \param[in] graph proper
 * \param[in] hops k, at least 1; with 1 every vertex is taken
 * \param[in] seed of the priorities
 * \param[in] threads 0 = all cores
 * \return the landmarks, in ascending order */
PCL_MANIFOLD_CORE_EXPORTS std::vector<pcl::index_t> maximalStableSet (const NeighborhoodGraph& graph,
                                                                      int hops, std::uint64_t seed,
                                                                      unsigned int threads);

/** \brief The graph Voronoi diagram of a graph: per vertex the number (position in \a landmarks) of the
 * nearest landmark in hops, the smallest of several; -1 where no landmark can be reached.
 * \param[in] graph proper
 * \param[in] landmarks distinct vertices
 * \param[in] threads 0 = all cores; the result is the same for any number */
PCL_MANIFOLD_CORE_EXPORTS std::vector<pcl::index_t> graphVoronoiDiagram (
  const NeighborhoodGraph& graph, const std::vector<pcl::index_t>& landmarks, unsigned int threads);

/** \brief When two tiles are adjacent. */
enum class AdjacencyRule
{
  BOUNDARY_POINTS, ///< b12 + b21 > a, b12 being the points of tile 1 that have a neighbour in tile 2 (3.1)
  LINKING_EDGES,   ///< the edges of the graph between both tiles are more than a (section 3)
  CLEAR_PATH ///< a path between the landmarks at least two hops from every other tile (section 2, step 4)
};

/** \brief Two tiles that touch each other. */
struct TileContact
{
  pcl::index_t first = 0;           ///< number of a landmark
  pcl::index_t second = 0;          ///< a larger one
  std::int32_t boundary_points = 0; ///< b12 + b21
  std::int32_t linking_edges = 0;   ///< edges of the graph between both tiles
  bool adjacent = false;            ///< by the rule
};

/** \brief All pairs of tiles that touch each other, in ascending order (section 3.1, "Landmark adjacencies").
 * \param[in] graph proper
 * \param[in] landmarks as for graphVoronoiDiagram
 * \param[in] tiles of graphVoronoiDiagram
 * \param[in] rule, threshold which of them are adjacent; the path rule has no threshold
 * \param[in] threads 0 = all cores; the result is the same for any number */
PCL_MANIFOLD_CORE_EXPORTS std::vector<TileContact> tileContacts (const NeighborhoodGraph& graph,
                                                                 const std::vector<pcl::index_t>& landmarks,
                                                                 const std::vector<pcl::index_t>& tiles,
                                                                 AdjacencyRule rule, int threshold,
                                                                 unsigned int threads);

} // namespace manifold
} // namespace pcl
