#include <pcl/manifold/detail/guarded.h>
#include <pcl/manifold/neighborhood_graph.h>

#include "common/parallel.h"
#include "graph/landmarks/reverse_edges.h"

#include <algorithm>

namespace pcl {
namespace manifold {

namespace {

bool
areInRange (const NeighborhoodGraph& graph)
{
  const pcl::index_t n = graph.size ();
  return graph.offsets.front () == 0 && graph.offsets.back () == graph.neighbors.size () &&
         std::is_sorted (graph.offsets.begin (), graph.offsets.end ()) &&
         std::all_of (graph.neighbors.begin (), graph.neighbors.end (),
                      [n] (pcl::index_t v) { return v >= 0 && v < n; });
}

// Every row sorted, without repetitions and without its own vertex.
NeighborhoodGraph
withProperRows (const NeighborhoodGraph& graph)
{
  const auto n = static_cast<std::size_t> (graph.size ());
  std::vector<pcl::index_t> sorted = graph.neighbors;
  NeighborhoodGraph result;
  result.offsets.resize (n + 1, 0);
  parallelFor (n, [&] (std::size_t v) {
    const auto row = sorted.begin () + static_cast<std::ptrdiff_t> (graph.offsets[v]);
    auto end = sorted.begin () + static_cast<std::ptrdiff_t> (graph.offsets[v + 1]);
    end = std::remove (row, end, static_cast<pcl::index_t> (v));
    std::sort (row, end);
    result.offsets[v + 1] = static_cast<std::size_t> (std::unique (row, end) - row);
  });
  for (std::size_t v = 0; v < n; ++v)
    result.offsets[v + 1] += result.offsets[v];
  result.neighbors.resize (result.offsets[n]);
  parallelFor (n, [&] (std::size_t v) {
    std::copy_n (sorted.data () + graph.offsets[v], result.offsets[v + 1] - result.offsets[v],
                 result.neighbors.data () + result.offsets[v]);
  });
  return result;
}

} // namespace

Status
symmetrize (const NeighborhoodGraph& directed, unsigned int threads, NeighborhoodGraph& graph) noexcept
{
  NeighborhoodGraph result;
  const Status status = guarded ([&] {
    if (directed.size () == 0)
      return directed.neighbors.empty () ? Status::NO_INPUT : Status::PARAMETER_OUT_OF_RANGE;
    if (!areInRange (directed))
      return Status::PARAMETER_OUT_OF_RANGE;
    withThreads (threads, [&] { result = withReverseEdges (withProperRows (directed)); });
    return Status::OK;
  });
  graph = std::move (result);
  return status;
}

} // namespace manifold
} // namespace pcl
