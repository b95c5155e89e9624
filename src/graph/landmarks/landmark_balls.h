#pragma once

#include <pcl/manifold/neighborhood_graph.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace pcl {
namespace manifold {

/** As many hops as vertices are away from which no landmark is known in less than the hops that are asked
 * for.
 */
constexpr int UNREACHED = std::numeric_limits<int>::max ();

/** The vertices that are nearer to a candidate than to all landmarks, by their hops from it. */
struct LandmarkBall
{
  std::vector<pcl::index_t> vertices;
  std::vector<std::size_t> ends; ///< those at a number of hops end before vertices[ends[hops]]
};

/** Searches less than `hops` hops around a vertex.
 *
 * It need not go on from where a landmark is as near: whatever lies behind is as near to that one, too. So it
 * gets smaller the more landmarks there are around it.
 * \param[in] hops_to_landmark per vertex
 * \param[in,out] seen a zero per vertex, before and after */
void findBall (const NeighborhoodGraph& graph, const std::vector<int>& hops_to_landmark, pcl::index_t center,
               int hops, std::vector<std::uint8_t>& seen, LandmarkBall& ball);

/** Makes the centre of a ball a landmark. */
void addLandmark (const LandmarkBall& ball, std::vector<int>& hops_to_landmark);

} // namespace manifold
} // namespace pcl
