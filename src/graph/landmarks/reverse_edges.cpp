#include "graph/landmarks/reverse_edges.h"

#include "common/large_pages.h"
#include "common/parallel.h"

#include <atomic>

namespace pcl {
namespace manifold {

namespace {

constexpr std::size_t VERTICES_PER_PIECE = 8192;

struct Edge
{
  pcl::index_t from;
  pcl::index_t to;
};

using Counters = std::vector<std::atomic<pcl::index_t>>;

// The edges that are in the row of their second end only, by pieces of the second ends, and how many of them
// start at each vertex.
std::vector<std::vector<Edge>>
findMissing (const NeighborhoodGraph& directed, Counters& missing_at)
{
  const auto n = static_cast<std::size_t> (directed.size ());
  std::vector<std::vector<Edge>> missing ((n + VERTICES_PER_PIECE - 1) / VERTICES_PER_PIECE);
  const auto find = [&] (std::size_t piece) {
    const std::size_t end = std::min (n, (piece + 1) * VERTICES_PER_PIECE);
    for (auto v = static_cast<pcl::index_t> (piece * VERTICES_PER_PIECE); v < static_cast<pcl::index_t> (end);
         ++v)
      for (const pcl::index_t* w = directed.begin (v); w != directed.end (v); ++w)
        if (!rowHolds (directed.begin (*w), directed.end (*w), v)) {
          missing[piece].push_back ({*w, v});
          missing_at[*w].fetch_add (1, std::memory_order_relaxed);
        }
  };
  parallelFor (missing.size (), find, 1);
  return missing;
}

// Merges a row with numbers that lie, sorted, at the end of the place where both together belong.
void
mergeRow (const pcl::index_t* row, const pcl::index_t* row_end, const pcl::index_t* added,
          const pcl::index_t* end, pcl::index_t* out)
{
  while (added != end)
    *out++ = row != row_end && *row < *added ? *row++ : *added++;
  std::copy (row, row_end, out);
}

} // namespace

NeighborhoodGraph
withReverseEdges (const NeighborhoodGraph& directed)
{
  const auto n = static_cast<std::size_t> (directed.size ());
  Counters missing_at (n);
  const std::vector<std::vector<Edge>> missing = findMissing (directed, missing_at);

  NeighborhoodGraph graph;
  assignLarge (graph.offsets, n + 1);
  for (std::size_t v = 0; v < n; ++v)
    graph.offsets[v + 1] = graph.offsets[v] + (directed.offsets[v + 1] - directed.offsets[v]) +
                           static_cast<std::size_t> (missing_at[v].load (std::memory_order_relaxed));
  assignLarge (graph.neighbors, graph.offsets[n]);
  const auto add = [&] (std::size_t piece) {
    for (const Edge& edge : missing[piece]) {
      const pcl::index_t before_end = missing_at[edge.from].fetch_sub (1, std::memory_order_relaxed);
      graph.neighbors[graph.offsets[edge.from + 1] - static_cast<std::size_t> (before_end)] = edge.to;
    }
  };
  parallelFor (missing.size (), add, 1);
  parallelFor (n, [&] (std::size_t i) {
    const auto v = static_cast<pcl::index_t> (i);
    pcl::index_t* row = graph.neighbors.data () + graph.offsets[i];
    pcl::index_t* end = graph.neighbors.data () + graph.offsets[i + 1];
    pcl::index_t* added = row + (directed.end (v) - directed.begin (v));
    std::sort (added, end);
    mergeRow (directed.begin (v), directed.end (v), added, end, row);
  });
  return graph;
}

} // namespace manifold
} // namespace pcl
