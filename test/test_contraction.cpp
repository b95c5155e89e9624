// No distance to a box is larger than one to a point in it, also where the processor can multiply and add
// with one rounding: this file and the kd-tree are compiled for such a one.
#include "points/kd_tree.h"

#include <gtest/gtest.h>

#include <array>
#include <random>

namespace {

using pcl::manifold::KdTree;

bool
runsHere ()
{
#if defined(__x86_64__) || defined(__i386__)
  return __builtin_cpu_supports ("fma") != 0;
#else
  return true;
#endif
}

double
coordinate (std::mt19937_64& random)
{
  return static_cast<double> (random () >> 11) * 0x1p-53;
}

// On the way down from the root to every leaf, from points in and around the boxes.
template <int D>
std::size_t
countBoxesTooFar (std::uint64_t seed)
{
  constexpr int POINTS = 3000;
  constexpr int QUERIES = 40;
  std::mt19937_64 random (seed);
  Eigen::MatrixXd points (3, POINTS);
  for (double& value : points.reshaped ())
    value = coordinate (random);
  const KdTree<D> tree (points);
  std::array<double, POINTS> distances{};
  std::size_t too_far = 0;
  for (int query = 0; query < QUERIES; ++query) {
    const std::array<double, 3> point{2 * coordinate (random), 2 * coordinate (random),
                                      coordinate (random) - 1};
    for (std::size_t node = 1; node < 2 * tree.leaves (); ++node) {
      const std::size_t first = tree.begin (node);
      const std::size_t last = tree.end (node);
      tree.squaredDistances (point.data (), first, last, distances.data ());
      const double to_box = tree.toBox (point.data (), node);
      const double to_corner = tree.toFarCorner (point.data (), node);
      for (std::size_t i = 0; i < last - first; ++i)
        too_far += to_box > distances[i] || to_corner < distances[i] ? 1 : 0;
    }
  }
  return too_far;
}

TEST (Contraction, NoBoxIsFartherThanAPointInIt)
{
  if (!runsHere ())
    GTEST_SKIP () << "this processor has no fused multiply-add";
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    EXPECT_EQ (countBoxesTooFar<3> (seed), 0U) << seed;
    EXPECT_EQ (countBoxesTooFar<Eigen::Dynamic> (seed), 0U) << seed;
  }
}

} // namespace
