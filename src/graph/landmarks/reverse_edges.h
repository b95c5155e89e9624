#pragma once

#include <pcl/manifold/neighborhood_graph.h>

#include <algorithm>

namespace pcl {
namespace manifold {

/** Does a row, in ascending order, hold a vertex? Most rows are short: looking at all of one takes fewer
 * cycles than the mispredicted branches of a binary search. */
inline bool
rowHolds (const pcl::index_t* begin, const pcl::index_t* end, pcl::index_t vertex)
{
  constexpr std::ptrdiff_t SHORT = 64;
  if (end - begin > SHORT)
    return std::binary_search (begin, end, vertex);
  int found = 0;
  for (const pcl::index_t* v = begin; v != end; ++v)
    found |= *v == vertex ? 1 : 0;
  return found != 0;
}

/** The proper graph of the edges of another, taken both ways. The rows of that one must be proper, apart from
 * edges that go one way only. Parallel in the current arena. */
NeighborhoodGraph withReverseEdges (const NeighborhoodGraph& directed);

} // namespace manifold
} // namespace pcl
