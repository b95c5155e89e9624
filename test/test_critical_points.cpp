// Poles of Voronoi cells against half-spaces, and the classification of critical points by them.
#include "oracle_lattice.h"
#include "oracle_voronoi.h"

#include "fixed_point/anchored.h"
#include "fixed_point/critical_points.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace {

using namespace oracle;
using pcl::manifold::anchoredTriangles;
using pcl::manifold::computePoles;
using pcl::manifold::Facet;
using pcl::manifold::findMedial;
using pcl::manifold::poleRatio;
using pcl::manifold::Poles;
using pcl::manifold::VoronoiCell;

// The farthest point of a Voronoi cell at more than a right angle to the positive pole; infinite where it is
// unbounded there. Sure where no vertex or ray is nearly at a right angle.
oracle::Pole
negativePole (const VoronoiOracle& cell, const Vector3l& positive)
{
  oracle::Pole pole;
  std::vector<Vector3l> behind;
  for (const VoronoiOracle::Ray& ray : cell.rays) {
    const long double cosine = ray.direction.dot (positive);
    pole.height_is_sure = pole.height_is_sure && std::abs (cosine) > 1e-6L;
    if (cosine < 0)
      pole.height = std::numeric_limits<long double>::infinity ();
  }
  for (const VoronoiOracle::Vertex& vertex : cell.vertices) {
    const long double along = vertex.position.dot (positive);
    pole.height_is_sure = pole.height_is_sure && std::abs (along) > 1e-6L * vertex.position.norm ();
    if (along < 0)
      pole.height = std::max (pole.height, static_cast<long double> (vertex.position.norm ()));
  }
  return pole;
}

TEST (CriticalPoints, PolesAreThoseOfTheDefinition)
{
  int bounded = 0;
  int half_bounded = 0;
  int unbounded = 0;
  forEachLattice (45, 4, 26, [&] (const Eigen::Matrix3Xd& cloud, int kind) {
    const auto complex = complexOf (cloud);
    if (complex->affine_dimension < 2 || testing::Test::HasFatalFailure ())
      return;
    for (int i = 0; i < static_cast<int> (cloud.cols ()); ++i) {
      const Poles result = computePoles (VoronoiCell (*complex, i));
      const VoronoiOracle cell = voronoiCell (cloud, i);
      ASSERT_NEAR (result.positive.direction.norm (), 1.0, 1e-9);
      ASSERT_NEAR (result.negative.direction.norm (), 1.0, 1e-9);
      ASSERT_EQ (std::isinf (result.positive.height), !cell.rays.empty ()) << kind;
      const oracle::Pole expected = negativePole (cell, result.positive.direction.cast<long double> ());
      if (!expected.height_is_sure || expected.height == 0)
        continue;
      ASSERT_LT (result.negative.direction.dot (result.positive.direction), 1e-9);
      if (std::isinf (expected.height)) {
        ASSERT_TRUE (std::isinf (result.negative.height)) << kind;
        ++unbounded;
      } else {
        ASSERT_NEAR (result.negative.height, static_cast<double> (expected.height),
                     1e-6 * static_cast<double> (expected.height))
          << kind;
        ++(cell.rays.empty () ? bounded : half_bounded);
      }
    }
  });
  EXPECT_GT (bounded, 1000);
  EXPECT_GT (half_bounded, 1000);
  EXPECT_GT (unbounded, 1000);
}

TEST (CriticalPoints, AreComparedWithThePoleOnTheirSide)
{
  Poles poles{{Eigen::Vector3d::UnitZ (), 10.0}, {-Eigen::Vector3d::UnitZ (), 4.0}};
  EXPECT_DOUBLE_EQ (poleRatio (poles, {0, 0, 5}), 0.5);
  EXPECT_DOUBLE_EQ (poleRatio (poles, {0, 0, -2}), 0.5);
  EXPECT_DOUBLE_EQ (poleRatio (poles, {3, 0, 4}), 0.5);
  EXPECT_DOUBLE_EQ (poleRatio (poles, {4, 0, -3}), 1.25);
  // Unbounded on one side: always the other one. On both: nothing is medial.
  poles.positive.height = std::numeric_limits<double>::infinity ();
  EXPECT_DOUBLE_EQ (poleRatio (poles, {0, 0, 5}), 1.25);
  EXPECT_DOUBLE_EQ (poleRatio (poles, {0, 0, -2}), 0.5);
  poles.negative.height = std::numeric_limits<double>::infinity ();
  EXPECT_EQ (poleRatio (poles, {0, 0, -2}), 0.0);
}

// Votes of the three samples of every anchored triangle, one by one.
TEST (CriticalPoints, AreMedialByVotes)
{
  std::size_t medial_by_one = 0;
  std::size_t medial_by_all = 0;
  forEachLattice (20, 4, 40, [&] (const Eigen::Matrix3Xd& cloud, int) {
    const auto complex = complexOf (cloud);
    if (complex->affine_dimension < 2)
      return;
    const std::vector<Facet> anchored = anchoredTriangles (*complex);
    for (int votes = 1; votes <= 3; ++votes) {
      const std::vector<std::uint8_t> medial = findMedial (*complex, anchored, {0.4, votes});
      ASSERT_EQ (medial.size (), anchored.size ());
      for (std::size_t i = 0; i < anchored.size (); ++i) {
        const std::array<std::int32_t, 3> samples = facetOf (*complex, anchored[i].cell, anchored[i].facet);
        const Eigen::Vector3d center = pcl::manifold::circumcenter (
          cloud.col (samples[0]), cloud.col (samples[1]), cloud.col (samples[2]));
        int count = 0;
        for (const std::int32_t v : samples)
          count += poleRatio (computePoles (VoronoiCell (*complex, v)), center - cloud.col (v)) > 0.4 ? 1 : 0;
        ASSERT_EQ (medial[i] != 0, count >= votes);
        medial_by_one += votes == 1 ? medial[i] : 0;
        medial_by_all += votes == 3 ? medial[i] : 0;
      }
    }
  });
  EXPECT_GT (medial_by_all, 500u);
  EXPECT_GT (medial_by_one, medial_by_all + 100);
}

// Samples of a sheet are unbounded on both sides: there is no medial axis to be near to.
TEST (CriticalPoints, OfAPlaneAreManifold)
{
  const Eigen::Matrix3Xd cloud = latticeCloud (Lattice::PLANE, 60, 1);
  const auto complex = complexOf (cloud);
  ASSERT_EQ (complex->affine_dimension, 2);
  const std::vector<Facet> anchored = anchoredTriangles (*complex);
  EXPECT_GT (anchored.size (), 10u);
  EXPECT_EQ (findMedial (*complex, anchored, {0.01, 1}), std::vector<std::uint8_t> (anchored.size (), 0));
}

} // namespace
