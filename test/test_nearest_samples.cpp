// The walk over Delaunay edges against a look at all samples.
#include "oracle_lattice.h"

#include "voronoi/nearest_samples.h"

#include <gtest/gtest.h>

namespace {

using namespace oracle;
using pcl::manifold::NearestSamples;

std::vector<std::int32_t>
nearestByLookingAtAll (const Eigen::Matrix3Xd& cloud, std::int32_t sample, int k)
{
  std::vector<std::pair<double, std::int32_t>> all;
  for (std::int32_t q = 0; q < cloud.cols (); ++q)
    if (q != sample)
      all.emplace_back ((cloud.col (q) - cloud.col (sample)).squaredNorm (), q);
  std::sort (all.begin (), all.end ());
  std::vector<std::int32_t> nearest;
  for (std::size_t i = 0; i < all.size () && i < static_cast<std::size_t> (k); ++i)
    nearest.push_back (all[i].second);
  return nearest;
}

// Distances of lattice points have no rounding errors, so that even ties are in their order.
TEST (NearestSamples, AreTheNearest)
{
  forEachLattice (60, 3, 60, [] (const Eigen::Matrix3Xd& cloud, int kind) {
    const auto complex = complexOf (cloud);
    if (complex->affine_dimension < 2)
      return;
    NearestSamples nearest (*complex);
    for (std::int32_t sample = 0; sample < cloud.cols (); ++sample)
      for (const int k : {0, 1, 4, 10, 100})
        ASSERT_EQ (nearest.find (sample, k), nearestByLookingAtAll (cloud, sample, k))
          << "kind " << kind << ", sample " << sample << ", k " << k;
  });
}

} // namespace
