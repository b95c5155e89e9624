#include <pcl/manifold/neighborhood_graph.h>

#include "graph/landmarks/reverse_edges.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <functional>

namespace pcl {
namespace manifold {

namespace {

// The first thing wrong with the offsets, or nothing.
std::string
faultOfOffsets (const NeighborhoodGraph& graph)
{
  if (graph.offsets.empty ())
    return graph.neighbors.empty () ? "" : "there are neighbours but no offsets";
  if (graph.offsets.front () != 0)
    return "the first offset is " + std::to_string (graph.offsets.front ()) + " instead of 0";
  if (graph.offsets.back () != graph.neighbors.size ())
    return "the last offset is " + std::to_string (graph.offsets.back ()) + ", but there are " +
           std::to_string (graph.neighbors.size ()) + " neighbours";
  const auto descent = std::adjacent_find (graph.offsets.begin (), graph.offsets.end (), std::greater<> ());
  if (descent != graph.offsets.end ())
    return "the offsets descend after vertex " + std::to_string (descent - graph.offsets.begin ());
  return "";
}

// What is wrong with the row of a vertex by itself, or nothing.
std::string
faultOfRow (const NeighborhoodGraph& graph, pcl::index_t vertex)
{
  const pcl::index_t* previous = nullptr;
  for (const pcl::index_t* w = graph.begin (vertex); w != graph.end (vertex); previous = w++) {
    const bool in_range = *w >= 0 && *w < graph.size ();
    if (in_range && *w != vertex && (!previous || *previous < *w))
      continue;
    const std::string at = "vertex " + std::to_string (vertex);
    if (!in_range)
      return at + " has the neighbour " + std::to_string (*w) + " of " + std::to_string (graph.size ()) +
             " vertices";
    if (*w == vertex)
      return at + " is its own neighbour";
    return at + " has the neighbour " + std::to_string (*w) + " after " + std::to_string (*previous);
  }
  return "";
}

// The first neighbour of a vertex that does not have it, or nothing. Rows must be right by themselves.
std::string
faultOfEdges (const NeighborhoodGraph& graph, pcl::index_t vertex)
{
  for (const pcl::index_t* w = graph.begin (vertex); w != graph.end (vertex); ++w)
    if (!rowHolds (graph.begin (*w), graph.end (*w), vertex))
      return "vertex " + std::to_string (vertex) + " has the neighbour " + std::to_string (*w) +
             ", which does not have it";
  return "";
}

// The fault of the first vertex that has one.
template <typename FaultOf>
std::string
firstFault (const NeighborhoodGraph& graph, const FaultOf& fault_of)
{
  const pcl::index_t n = graph.size ();
  const pcl::index_t first = tbb::parallel_reduce (
    tbb::blocked_range<pcl::index_t> (0, n, 1024), n,
    [&] (const tbb::blocked_range<pcl::index_t>& range, pcl::index_t found) {
      for (pcl::index_t v = range.begin (); v != range.end () && v < found; ++v)
        if (!fault_of (graph, v).empty ())
          return v;
      return found;
    },
    [] (pcl::index_t a, pcl::index_t b) { return std::min (a, b); });
  return first == n ? "" : fault_of (graph, first);
}

std::string
faultOf (const NeighborhoodGraph& graph)
{
  std::string fault = faultOfOffsets (graph);
  if (fault.empty ())
    fault = firstFault (graph, faultOfRow);
  if (fault.empty ())
    fault = firstFault (graph, faultOfEdges);
  return fault;
}

} // namespace

bool
isProper (const NeighborhoodGraph& graph, std::string* why)
{
  const std::string fault = faultOf (graph);
  if (why)
    *why = fault;
  return fault.empty ();
}

} // namespace manifold
} // namespace pcl
