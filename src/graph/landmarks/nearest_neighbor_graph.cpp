#include <pcl/manifold/detail/guarded.h>
#include <pcl/manifold/neighborhood_graph.h>

#include "common/large_pages.h"
#include "common/parallel.h"
#include "graph/landmarks/reverse_edges.h"
#include "points/nearest_neighbors.h"

#include <algorithm>
#include <cmath>

namespace pcl {
namespace manifold {

namespace {

// Finite, and so near each other that squared distances are as well.
bool
areInRange (const Eigen::Ref<const Eigen::MatrixXd>& points)
{
  return points.allFinite () &&
         std::isfinite ((points.rowwise ().maxCoeff () - points.rowwise ().minCoeff ()).squaredNorm ());
}

} // namespace

Status
nearestNeighborGraph (const Eigen::Ref<const Eigen::MatrixXd>& points, int k, unsigned int threads,
                      NeighborhoodGraph& graph, const ProgressCallback& progress) noexcept
{
  graph.offsets.clear ();
  graph.neighbors.clear ();
  return guarded ([&] {
    if (k < 1)
      return Status::PARAMETER_OUT_OF_RANGE;
    if (points.size () == 0)
      return Status::NO_INPUT;
    if (!areInRange (points))
      return Status::INPUT_OUT_OF_RANGE;
    const auto n = static_cast<std::size_t> (points.cols ());
    const std::size_t row = std::min (static_cast<std::size_t> (k), n - 1);
    NeighborhoodGraph result;
    bool cancelled = false;
    withThreads (threads, [&] {
      NeighborhoodGraph directed;
      directed.neighbors = kNearestNeighbors (points, static_cast<int> (row), progress);
      cancelled = directed.neighbors.size () != n * row;
      if (cancelled)
        return;
      assignLarge (directed.offsets, n + 1);
      for (std::size_t i = 0; i <= n; ++i)
        directed.offsets[i] = i * row;
      result = withReverseEdges (directed);
    });
    graph = std::move (result);
    return cancelled ? Status::CANCELLED : Status::OK;
  });
}

} // namespace manifold
} // namespace pcl
