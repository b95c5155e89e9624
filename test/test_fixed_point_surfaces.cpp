// What the theory says of dense samples of closed surfaces: Theorems 10 and 13 and Lemmas 5 and 12 of Khoury
// and Shewchuk.
#include "oracle_clouds.h"

#include "fixed_point/facet_flags.h"

#include <pcl/manifold/fixed_point_complex.h>

#include "delaunay/circumcenter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace {

using namespace oracle;
using Eigen::Vector3d;
using pcl::manifold::computeFixedPointComplex;
using pcl::manifold::Facet;
using pcl::manifold::FacetFlags;
using pcl::manifold::facetsOf;
using pcl::manifold::FixedPoint;
using pcl::manifold::fixedPoint;
using pcl::manifold::FixedPointComplex;
using pcl::manifold::FlatPieces;
using pcl::manifold::restrictedDelaunay;
using pcl::manifold::StageLog;
using pcl::manifold::Status;

constexpr double EPSILON = 0.143;

/** A torus around the z axis, or a sphere where the large radius is zero; scaled so that its local feature
 * size is nowhere less than 1. */
struct Surface
{
  double large;
  double small;

  Vector3d at (double a, double b, double offset) const
  {
    const double radius = small + offset;
    if (large == 0.0)
      return {radius * std::cos (a) * std::sin (b / 2), radius * std::sin (a) * std::sin (b / 2),
              radius * std::cos (b / 2)};
    const double out = large + radius * std::cos (b);
    return {out * std::cos (a), out * std::sin (a), radius * std::sin (b)};
  }

  double distance (const Vector3d& p) const
  {
    if (large == 0.0)
      return std::abs (p.norm () - small);
    return std::abs (std::hypot (std::hypot (p.x (), p.y ()) - large, p.z ()) - small);
  }

  Vector3d anyPoint (Random& random) const
  {
    if (large == 0.0)
      return small * onSphere (random);
    for (;;) {
      const double b = random.uniform (0, 2 * M_PI);
      if (random.uniform () * (large + small) < large + small * std::cos (b))
        return at (random.uniform (0, 2 * M_PI), b, 0);
    }
  }
};

const Surface SPHERE{0.0, 1.0};
const Surface TORUS{2.0, 1.0};

double
distanceToNearest (const std::vector<Vector3d>& points, const Vector3d& x)
{
  double nearest = std::numeric_limits<double>::infinity ();
  for (const Vector3d& p : points)
    nearest = std::min (nearest, (p - x).squaredNorm ());
  return std::sqrt (nearest);
}

// Random points that are not too near each other, until no place is left, but for luck, that is farther than
// epsilon from all of them.
Eigen::Matrix3Xd
epsilonSample (const Surface& surface, Random& random)
{
  std::vector<Vector3d> points;
  for (int failures = 0; failures < 3000;) {
    const Vector3d x = surface.anyPoint (random);
    if (distanceToNearest (points, x) > 0.85 * EPSILON) {
      points.push_back (x);
      failures = 0;
    } else {
      ++failures;
    }
  }
  Eigen::Matrix3Xd result (3, static_cast<Eigen::Index> (points.size ()));
  for (std::size_t i = 0; i < points.size (); ++i)
    result.col (static_cast<Eigen::Index> (i)) = points[i];
  return result;
}

// A mesh around the surface with its vertices anywhere within some distance of it.
FlatPieces
roughMesh (const Surface& surface, double distance, Random& random)
{
  constexpr int ROWS = 40;
  constexpr int COLUMNS = 60;
  FlatPieces mesh;
  mesh.vertices.resize (3, ROWS * COLUMNS);
  for (int i = 0; i < ROWS; ++i)
    for (int k = 0; k < COLUMNS; ++k)
      mesh.vertices.col (i * COLUMNS + k) =
        surface.at (2 * M_PI * k / COLUMNS, 2 * M_PI * i / ROWS, random.uniform (-distance, distance));
  for (int i = 0; i < ROWS; ++i)
    for (int k = 0; k < COLUMNS; ++k) {
      const int right = i * COLUMNS + (k + 1) % COLUMNS;
      const int down = (i + 1) % ROWS * COLUMNS + k;
      const int both = (i + 1) % ROWS * COLUMNS + (k + 1) % COLUMNS;
      mesh.triangles.push_back ({i * COLUMNS + k, right, down});
      mesh.triangles.push_back ({right, both, down});
    }
  return mesh;
}

void
expectTheory (const Surface& surface, std::uint64_t seed)
{
  SCOPED_TRACE (testing::Message () << "torus of " << surface.large << ", seed " << seed);
  Random random (seed);
  const Eigen::Matrix3Xd cloud = epsilonSample (surface, random);
  const auto complex = complexOf (cloud);
  StageLog log;
  FixedPointComplex result;
  ASSERT_EQ (computeFixedPointComplex (*complex, {0.313, 1}, log, result), Status::OK);

  // Lemma 12: whichever vertex is asked.
  FixedPointComplex by_all;
  ASSERT_EQ (computeFixedPointComplex (*complex, {0.313, 3}, log, by_all), Status::OK);
  EXPECT_TRUE (result.manifold == by_all.manifold);

  // Theorem 10, for an epsilon of 0.143.
  const auto centerOfFacet = [&] (const Facet& facet) {
    const std::array<std::int32_t, 3> t = facetOf (*complex, facet.cell, facet.facet);
    return pcl::manifold::circumcenter (cloud.col (t[0]), cloud.col (t[1]), cloud.col (t[2]));
  };
  for (const Facet& facet : facetsOf (*complex, result.manifold))
    EXPECT_LT (surface.distance (centerOfFacet (facet)), 0.0107);
  for (const Facet& facet : facetsOf (*complex, result.medial))
    EXPECT_GT (surface.distance (centerOfFacet (facet)), 0.9);

  // Theorem 13, by the distances of centroids and of the middles of sides.
  const std::vector<Facet> facets = facetsOf (*complex, result.facets);
  EXPECT_GE (facets.size (), 2u * static_cast<std::size_t> (cloud.cols ()) - 4u);
  for (const Facet& facet : facets) {
    const std::array<std::int32_t, 3> t = facetOf (*complex, facet.cell, facet.facet);
    EXPECT_LT (surface.distance ((cloud.col (t[0]) + cloud.col (t[1]) + cloud.col (t[2])) / 3), 0.0147);
    for (int k = 0; k < 3; ++k)
      EXPECT_LT (surface.distance ((cloud.col (t[k]) + cloud.col (t[(k + 1) % 3])) / 2), 0.0147);
  }

  // Lemma 5: from anywhere in the sausage into the complex.
  for (const double distance : {0.0, 0.2, 0.5, 0.7}) {
    FacetFlags start;
    ASSERT_EQ (restrictedDelaunay (*complex, roughMesh (surface, distance, random), start), Status::OK);
    const FixedPoint fixed = fixedPoint (*complex, start);
    EXPECT_TRUE (restrictedDelaunay (*complex, fixed.facets) == fixed.facets);
    EXPECT_GT (facetsOf (*complex, fixed.facets).size (), facets.size () / 2);
    for (std::size_t i = 0; i < fixed.facets.mask.size (); ++i)
      ASSERT_EQ (fixed.facets.mask[i] & ~result.facets.mask[i], 0) << distance;
  }
}

TEST (FixedPointSurfaces, OfASphere)
{
  for (std::uint64_t seed = 1; seed <= 10; ++seed)
    expectTheory (SPHERE, seed);
}

TEST (FixedPointSurfaces, OfATorus)
{
  for (std::uint64_t seed = 1; seed <= 3; ++seed)
    expectTheory (TORUS, seed);
}

} // namespace
