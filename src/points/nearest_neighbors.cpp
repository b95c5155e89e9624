#include "points/nearest_neighbors.h"

#include "common/parallel.h"

#include <flann/flann.hpp>

namespace pcl {
namespace manifold {

namespace {

using Index = flann::KDTreeSingleIndex<flann::L2_Simple<double>>;

// FLANN takes a non-const pointer but does not write through it.
flann::Matrix<double>
asFlann (const Eigen::Matrix3Xd& points, std::size_t begin, std::size_t end)
{
  return flann::Matrix<double> (const_cast<double*> (points.data ()) + 3 * begin, end - begin, 3);
}

// Neighbours come in the order of FLANN's result set: by distance.
constexpr std::size_t QUERIES_PER_BATCH = 4096;

flann::SearchParams
exactSearch ()
{
  flann::SearchParams parameters (flann::FLANN_CHECKS_UNLIMITED, 0.0f, true);
  parameters.cores = 1;
  return parameters;
}

} // namespace

std::vector<std::int32_t>
kNearestNeighbors (const Eigen::Matrix3Xd& points, int k)
{
  const auto n = static_cast<std::size_t> (points.cols ());
  Index index (asFlann (points, 0, n), flann::KDTreeSingleIndexParams (15));
  index.buildIndex ();
  std::vector<std::int32_t> neighbors (n * k);
  const auto search = [&] (std::size_t begin, std::size_t end) {
    const auto row = static_cast<std::size_t> (k) + 1;
    std::vector<std::size_t> found ((end - begin) * row);
    std::vector<double> distances (found.size ());
    flann::Matrix<std::size_t> found_matrix (found.data (), end - begin, row);
    flann::Matrix<double> distance_matrix (distances.data (), end - begin, row);
    index.knnSearch (asFlann (points, begin, end), found_matrix, distance_matrix, row, exactSearch ());
    for (std::size_t i = begin; i < end; ++i) {
      std::int32_t* out = neighbors.data () + i * k;
      int count = 0;
      for (std::size_t j = 0; j < row && count < k; ++j)
        if (found[(i - begin) * row + j] != i)
          out[count++] = static_cast<std::int32_t> (found[(i - begin) * row + j]);
    }
  };
  parallelRanges (n, search, QUERIES_PER_BATCH);
  return neighbors;
}

std::vector<std::int32_t>
nearestPoints (const Eigen::Matrix3Xd& points, const Eigen::Matrix3Xd& queries)
{
  const auto n = static_cast<std::size_t> (points.cols ());
  Index index (asFlann (points, 0, n), flann::KDTreeSingleIndexParams (15));
  index.buildIndex ();
  std::vector<std::int32_t> nearest (static_cast<std::size_t> (queries.cols ()));
  const auto search = [&] (std::size_t begin, std::size_t end) {
    std::vector<std::size_t> found (end - begin);
    std::vector<double> distances (found.size ());
    flann::Matrix<std::size_t> found_matrix (found.data (), end - begin, 1);
    flann::Matrix<double> distance_matrix (distances.data (), end - begin, 1);
    index.knnSearch (asFlann (queries, begin, end), found_matrix, distance_matrix, 1, exactSearch ());
    for (std::size_t i = begin; i < end; ++i)
      nearest[i] = static_cast<std::int32_t> (found[i - begin]);
  };
  parallelRanges (nearest.size (), search, QUERIES_PER_BATCH);
  return nearest;
}

} // namespace manifold
} // namespace pcl
