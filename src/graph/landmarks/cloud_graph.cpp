#include <pcl/manifold/cloud_graph.h>
#include <pcl/manifold/detail/guarded.h>

#include "common/parallel.h"
#include "graph/landmarks/cloud_vertices.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace pcl {
namespace manifold {

namespace {

constexpr pcl::index_t FEWEST_VERTICES = 3;

// How far the whole computation is after this part of it: most of the time is the search's.
constexpr float GRAPH_BEGINS = 0.05f;
constexpr float GRAPH_ENDS = 0.55f;

// So many queries of a search of the user's own are made before the user is asked whether to go on.
constexpr std::size_t QUERIES_PER_QUESTION = 16384;

/** Collects the neighbours of every vertex by a search of the user's own, each row in no order. */
NeighborhoodGraph
searchNeighbors (const CloudGraph& cloud, int k, const NeighborSearch& search,
                 const ProgressCallback& progress)
{
  const auto n = cloud.input_index.size ();
  const auto wanted = std::min<std::size_t> (static_cast<std::size_t> (k), n - 1);
  const pcl::index_t largest = *std::max_element (cloud.input_index.begin (), cloud.input_index.end ());
  std::vector<pcl::index_t> vertex_at (static_cast<std::size_t> (largest) + 1, -1);
  for (std::size_t v = 0; v < n; ++v)
    vertex_at[cloud.input_index[v]] = static_cast<pcl::index_t> (v);

  search.prepare (cloud.input_index);
  NeighborhoodGraph directed;
  directed.offsets.push_back (0);
  pcl::Indices found;
  std::vector<pcl::index_t> row;
  for (std::size_t v = 0; v < n; ++v) {
    if (v % QUERIES_PER_QUESTION == QUERIES_PER_QUESTION - 1 &&
        !progress (static_cast<float> (v) / static_cast<float> (n)))
      return {};
    // A search that does not keep to the vertices may answer with duplicates of a point alone: then more are
    // asked for.
    for (std::size_t count = wanted + 1;; count *= 2) {
      const auto asked = static_cast<int> (std::min<std::size_t> (count, INT32_MAX));
      const int answered = search.nearest (cloud.input_index[v], asked, found);
      row.clear ();
      for (int i = 0; i < answered && row.size () < wanted; ++i) {
        const pcl::index_t point = found[static_cast<std::size_t> (i)];
        const pcl::index_t neighbor = point >= 0 && point <= largest ? vertex_at[point] : -1;
        if (neighbor >= 0 && static_cast<std::size_t> (neighbor) != v)
          row.push_back (neighbor);
      }
      if (row.size () == wanted || answered < asked || asked == INT32_MAX)
        break;
    }
    directed.neighbors.insert (directed.neighbors.end (), row.begin (), row.end ());
    directed.offsets.push_back (directed.neighbors.size ());
  }
  return directed;
}

Status
make (Eigen::MatrixXd points, const pcl::Indices& indices, double resolution, int k,
      const NeighborSearch& search, unsigned int threads, StageLog& log, CloudGraph& result)
{
  if (k < 1)
    return Status::PARAMETER_OUT_OF_RANGE;
  if (!log.begin ("points", 0.0f))
    return Status::CANCELLED;
  CloudGraph cloud;
  Status status = findVertices (std::move (points), indices, resolution, cloud);
  if (status != Status::OK)
    return status;
  if (cloud.points.cols () < FEWEST_VERTICES)
    return Status::TOO_FEW_POINTS;

  if (!log.begin ("neighbourhood graph", GRAPH_BEGINS))
    return Status::CANCELLED;
  const auto progress = [&log] (float share) {
    return log.proceed (GRAPH_BEGINS + (GRAPH_ENDS - GRAPH_BEGINS) * share);
  };
  if (search.nearest)
    status = symmetrize (searchNeighbors (cloud, k, search, progress), threads, cloud.graph);
  else
    status = nearestNeighborGraph (cloud.points, k, threads, cloud.graph, progress);
  if (log.cancelled ())
    return Status::CANCELLED;
  if (status == Status::OK)
    result = std::move (cloud);
  return status;
}

} // namespace

Status
makeCloudGraph (Eigen::MatrixXd points, const pcl::Indices& indices, double resolution, int k,
                const NeighborSearch& search, unsigned int threads, StageLog& log,
                CloudGraph& result) noexcept
{
  return guarded ([&] {
    result = CloudGraph ();
    Status status = Status::OK;
    withThreads (threads, [&] {
      status = make (std::move (points), indices, resolution, k, search, threads, log, result);
    });
    return status;
  });
}

Status
takeGraph (const NeighborhoodGraph& given, const pcl::Indices& indices, unsigned int threads, StageLog& log,
           CloudGraph& result) noexcept
{
  return guarded ([&] {
    result = CloudGraph ();
    const pcl::index_t n = given.size ();
    if (!indices.empty () && indices.size () != static_cast<std::size_t> (n))
      return Status::PARAMETER_OUT_OF_RANGE;
    if (!log.begin ("neighbourhood graph", GRAPH_BEGINS))
      return Status::CANCELLED;
    CloudGraph cloud;
    const Status status = symmetrize (given, threads, cloud.graph);
    if (status != Status::OK)
      return status;
    if (n < FEWEST_VERTICES)
      return Status::TOO_FEW_POINTS;
    cloud.vertex_of.resize (static_cast<std::size_t> (n));
    std::iota (cloud.vertex_of.begin (), cloud.vertex_of.end (), 0);
    cloud.input_index = indices.empty () ? cloud.vertex_of : indices;
    result = std::move (cloud);
    return Status::OK;
  });
}

} // namespace manifold
} // namespace pcl
