// Poles and heights of the Voronoi subpolytopes against half-spaces.
#include "oracle_lattice.h"
#include "oracle_voronoi.h"

#include "voronoi/subpolytopes.h"

#include <gtest/gtest.h>

namespace {

using namespace oracle;
using pcl::manifold::computeSubpolytopes;
using pcl::manifold::Subpolytopes;
using pcl::manifold::VoronoiCell;

// How many poles there were to compare, of V1, V2 and V3.
struct Compared
{
  int heights[3] = {0, 0, 0};
  int directions[3] = {0, 0, 0};
};

void
compare (const Pole& expected, const Eigen::Vector3d& direction, double height, int i, Compared& compared)
{
  ASSERT_FALSE (std::isnan (height));
  ASSERT_GE (height, 0.0);
  if (expected.height_is_sure) {
    ++compared.heights[i];
    if (std::isinf (expected.height))
      ASSERT_TRUE (std::isinf (height));
    else
      ASSERT_NEAR (height, static_cast<double> (expected.height),
                   1e-6 * static_cast<double> (expected.height));
  }
  if (expected.direction_is_sure) {
    ++compared.directions[i];
    ASSERT_LT ((direction.cast<long double> () - expected.direction).norm (), 1e-5L);
  }
}

void
compareCell (const VoronoiOracle& cell, const Subpolytopes& result, Compared& compared)
{
  Eigen::Matrix3d frame;
  frame << result.normal, result.binormal, result.tangent;
  ASSERT_LT ((frame.transpose () * frame - Eigen::Matrix3d::Identity ()).norm (), 1e-9) << frame;
  compare (poleOfV3 (cell), result.normal, result.heights[2], 2, compared);
  // The sections are those of the directions that were chosen.
  compare (poleOfV2 (cell, result.normal.cast<long double> ()), result.binormal, result.heights[1], 1,
           compared);
  compare (poleOfV1 (cell, result.tangent.cast<long double> ()), result.tangent, result.heights[0], 0,
           compared);
}

TEST (Subpolytopes, AreThoseOfTheDefinition)
{
  Compared compared;
  forEachLattice (45, 3, 26, [&compared] (const Eigen::Matrix3Xd& cloud, int kind) {
    const auto complex = complexOf (cloud);
    if (complex->affine_dimension < 2 || testing::Test::HasFatalFailure ())
      return;
    for (int i = 0; i < static_cast<int> (cloud.cols ()); ++i) {
      const Subpolytopes result = computeSubpolytopes (*complex, VoronoiCell (*complex, i));
      SCOPED_TRACE (testing::Message () << "kind " << kind << ", sample " << i << " of\n"
                                        << cloud << "\nheights " << result.heights.transpose ());
      compareCell (voronoiCell (cloud, i), result, compared);
    }
  });
  for (int i = 0; i < 3; ++i) {
    EXPECT_GT (compared.heights[i], 7000);
    EXPECT_GT (compared.directions[i], 5000);
  }
}

// The average of unbounded edges vanishes: their common axis takes its place.
TEST (Subpolytopes, OfAPlaneHaveItsNormal)
{
  for (const Lattice kind : {Lattice::PLANE, Lattice::FLAT_GRID})
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
      const Eigen::Matrix3Xd cloud = latticeCloud (kind, 20, seed);
      const auto complex = complexOf (cloud);
      if (complex->affine_dimension != 2)
        continue;
      const Eigen::Vector3d normal = complex->centers.col (0);
      for (int i = 0; i < static_cast<int> (cloud.cols ()); ++i) {
        const Subpolytopes result = computeSubpolytopes (*complex, VoronoiCell (*complex, i));
        ASSERT_GT (std::abs (result.normal.dot (normal)), 1.0 - 1e-12);
        ASSERT_TRUE (std::isinf (result.heights[2]));
      }
    }
}

// Two layers are unbounded above and below, and at their sides.
TEST (Subpolytopes, OfAThinSlabHaveItsNormal)
{
  Random random (3);
  Eigen::Matrix3Xd cloud (3, 200);
  for (Eigen::Index i = 0; i < cloud.cols (); ++i)
    cloud.col (i) =
      Eigen::Vector3d (random.integer (-1000, 1000), random.integer (-1000, 1000), random.index (2));
  const auto complex = complexOf (cloud);
  int inner = 0;
  for (int i = 0; i < static_cast<int> (cloud.cols ()); ++i) {
    if (cloud.col (i).head<2> ().cwiseAbs ().maxCoeff () > 800)
      continue;
    ++inner;
    const Subpolytopes result = computeSubpolytopes (*complex, VoronoiCell (*complex, i));
    EXPECT_GT (std::abs (result.normal.z ()), 0.99) << i;
    EXPECT_LT (result.heights[1], 1000.0) << i;
  }
  EXPECT_GT (inner, 50);
}

} // namespace
