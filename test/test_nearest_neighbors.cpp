// The kd-tree against a look at all points.
#include "oracle_points.h"

#include "common/parallel.h"
#include "points/nearest_neighbors.h"

#include <gtest/gtest.h>

#include <tbb/global_control.h>

#include <limits>

namespace {

using namespace oracle;
using pcl::manifold::kNearestNeighbors;
using pcl::manifold::nearestPoints;

TEST (NearestNeighbors, AreTheNearest)
{
  for (int round = 0; round < 3000; ++round) {
    Random random (static_cast<std::uint64_t> (round));
    const int dimension = random.integer (1, 7);
    const int n = round < 30 ? 2 + round % 15 : random.integer (2, round % 200 == 0 ? 1000 : 90);
    const Eigen::MatrixXd points = randomPoints (dimension, n, random);
    for (const int k : {1, std::min (n - 1, random.integer (1, 40)), n - 1}) {
      const std::vector<index_t> found = kNearestNeighbors (points, k);
      ASSERT_EQ (found, nearestByLookingAtAll (points, k).neighbors)
        << "round " << round << ", R^" << dimension << ", " << n << " points, k " << k;
    }
  }
}

TEST (NearestNeighbors, OfPointsThatAreAllEqualHaveTheSmallestIndices)
{
  const Eigen::MatrixXd points = Eigen::MatrixXd::Constant (3, 200, 0.3);
  for (const int k : {1, 15, 16, 40, 199})
    ASSERT_EQ (kNearestNeighbors (points, k), nearestByLookingAtAll (points, k).neighbors) << k;
}

TEST (NearestNeighbors, OfAGridOfPoints)
{
  Eigen::MatrixXd points (3, 1000);
  for (int i = 0; i < 1000; ++i)
    points.col (i) << 0.1 * (i % 10), 0.1 * (i / 10 % 10), 0.1 * (i / 100);
  for (const int k : {1, 6, 15, 26, 100})
    ASSERT_EQ (kNearestNeighbors (points, k), nearestByLookingAtAll (points, k).neighbors) << k;
}

TEST (NearestNeighbors, OfManyPoints)
{
  Random random (5);
  Eigen::MatrixXd points (3, 30000);
  for (Eigen::Index i = 0; i < points.cols (); ++i)
    points.col (i) << random.uniform (), random.uniform (), 0.01 * random.uniform ();
  const std::vector<index_t> found = kNearestNeighbors (points, 15);
  const tbb::global_control four (tbb::global_control::max_allowed_parallelism, 4);
  for (const unsigned int threads : {1u, 2u, 4u}) {
    std::vector<index_t> again;
    pcl::manifold::withThreads (threads, [&] { again = kNearestNeighbors (points, 15); });
    ASSERT_EQ (found, again) << threads;
  }
  for (Eigen::Index i = 0; i < points.cols (); i += 97) {
    std::vector<std::pair<double, index_t>> all;
    for (Eigen::Index j = 0; j < points.cols (); ++j)
      if (j != i)
        all.emplace_back ((points.col (j) - points.col (i)).squaredNorm (), static_cast<index_t> (j));
    std::partial_sort (all.begin (), all.begin () + 15, all.end ());
    std::set<index_t> nearest;
    for (int j = 0; j < 15; ++j)
      nearest.insert (all[static_cast<std::size_t> (j)].second);
    ASSERT_EQ (std::set<index_t> (found.begin () + 15 * i, found.begin () + 15 * (i + 1)), nearest);
  }
}

TEST (NearestNeighbors, NearestPointsAreTheNearest)
{
  for (int round = 0; round < 1000; ++round) {
    Random random (static_cast<std::uint64_t> (round));
    const Eigen::Matrix3Xd points = randomPoints (3, random.integer (1, 100), random);
    Eigen::Matrix3Xd queries = randomPoints (3, random.integer (0, 30), random);
    if (random.coin () && queries.cols () > 0)
      queries.col (0) = points.col (0);
    const std::vector<std::int32_t> found = nearestPoints (points, queries);
    ASSERT_EQ (found.size (), static_cast<std::size_t> (queries.cols ()));
    for (Eigen::Index i = 0; i < queries.cols (); ++i) {
      std::pair<double, std::int32_t> nearest (std::numeric_limits<double>::infinity (), -1);
      for (Eigen::Index j = 0; j < points.cols (); ++j) {
        double squared = 0.0;
        for (int axis = 0; axis < 3; ++axis)
          squared += std::pow (points (axis, j) - queries (axis, i), 2);
        nearest = std::min (nearest, {squared, static_cast<std::int32_t> (j)});
      }
      ASSERT_EQ (found[static_cast<std::size_t> (i)], nearest.second) << "round " << round;
    }
  }
}

} // namespace
