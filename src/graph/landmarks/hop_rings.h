#pragma once

#include <pcl/manifold/neighborhood_graph.h>

#include <cstddef>
#include <vector>

namespace pcl {
namespace manifold {

/** Finds out how large the disks around vertices are. Keeps its scratch memory between calls; one object a
 * thread. */
class HopRings
{
public:
  explicit HopRings (const NeighborhoodGraph& graph);

  /** The largest r such that the rings of up to r hops around a vertex hang together, two by two, and that
   * there are as many.
   * \param[in] least rings of up to so many hops are not looked at: for whom a smaller answer is the same
   * \param[in] most the answer is this, or less by an even number */
  int radiusOfDisk (pcl::index_t center, int least, int most);

private:
  bool hangsTogether (std::size_t begin, std::size_t end, int hops);

  const NeighborhoodGraph& graph_;
  std::vector<int> hops_;              ///< per vertex, of those in the ball
  std::vector<pcl::index_t> vertices_; ///< of the ball, ring by ring
  std::vector<pcl::index_t> stack_;
};

} // namespace manifold
} // namespace pcl
