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
 * \return the landmarks, in ascending order
 * \ingroup manifold */
PCL_MANIFOLD_CORE_EXPORTS std::vector<pcl::index_t> maximalStableSet (const NeighborhoodGraph& graph,
                                                                      int hops, std::uint64_t seed,
                                                                      unsigned int threads);

/** \brief The graph Voronoi diagram of a graph: per vertex the number (position in \a landmarks) of the
 * nearest landmark in hops, the smallest of several. Linear in the number of edges.
 * \param[in] graph proper
 * \param[in] landmarks distinct vertices
 * \param[in] threads 0 = all cores; the result is the same for any number
 * \return per vertex a position in \a landmarks; -1 where no landmark can be reached
 * \ingroup manifold */
PCL_MANIFOLD_CORE_EXPORTS std::vector<pcl::index_t> graphVoronoiDiagram (
  const NeighborhoodGraph& graph, const std::vector<pcl::index_t>& landmarks, unsigned int threads);

/** \brief When two tiles are adjacent.
 * \ingroup manifold */
enum class AdjacencyRule
{
  BOUNDARY_POINTS, ///< b12 + b21 > a, b12 being the points of tile 1 that have a neighbour in tile 2 (3.1)
  LINKING_EDGES,   ///< the edges of the graph between both tiles are more than a (section 3)
  CLEAR_PATH ///< a path between the landmarks at least two hops from every other tile (section 2, step 4)
};

/** \brief Two tiles that touch each other.
 * \ingroup manifold */
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
 * \param[in] threads 0 = all cores; the result is the same for any number
 * \return pairs of tiles that touch, adjacent or not
 * \ingroup manifold */
PCL_MANIFOLD_CORE_EXPORTS std::vector<TileContact> tileContacts (const NeighborhoodGraph& graph,
                                                                 const std::vector<pcl::index_t>& landmarks,
                                                                 const std::vector<pcl::index_t>& tiles,
                                                                 AdjacencyRule rule, int threshold,
                                                                 unsigned int threads);

/** \brief Adds landmarks where tiles could not tell the topology of the surface: on thin tubes and handles,
 * beside narrow gaps, and on small surfaces. Of this library, not in the paper.
 *
 * The rings around a landmark, the vertices at each number of hops from it, hang together as long as the ball
 * inside of them is a disk; where the ball reaches around a tube they fall in two, each at least a quarter of
 * the whole. In a mesh of landmarks, all tiles around a tile have to be a disk: so landmarks should be no
 * further apart than 5/8 of the radius of the largest disk, less than k hops then, but never less than 3.
 * Vertices within 3/5 k hops of such a landmark become landmarks in the order of the priorities of
 * maximalStableSet, at that smaller distance from others; and those are looked at likewise, until there are
 * no new ones.
 *
 * Only landmarks around which the tiles do not look like a disk are looked at: those at one step from a tile,
 * or those at two, which do not hang together by contacts or are not there.
 * \param[in] graph proper
 * \param[in] hops k, as for maximalStableSet; there is nothing to add for 3 or less
 * \param[in] seed of the priorities
 * \param[in] landmarks of maximalStableSet, or what came of them here
 * \param[in] tiles of graphVoronoiDiagram
 * \param[in] contacts of tileContacts, by any rule
 * \param[in] crowded tiles around which landmarks may be at 3 hops whatever the rings say: those of faces
 * that pass a landmark twice, for instance
 * \param[in] threads 0 = all cores; the result is the same for any number
 * \return all landmarks, in ascending order
 * \ingroup manifold */
PCL_MANIFOLD_CORE_EXPORTS std::vector<pcl::index_t> refineLandmarks (
  const NeighborhoodGraph& graph, int hops, std::uint64_t seed, const std::vector<pcl::index_t>& landmarks,
  const std::vector<pcl::index_t>& tiles, const std::vector<TileContact>& contacts,
  const std::vector<pcl::index_t>& crowded, unsigned int threads);

} // namespace manifold
} // namespace pcl
