// Exact decisions about points and Voronoi cells against numbers without rounding.
#include "oracle_exact.h"
#include "oracle_nudged.h"

#include "fixed_point/predicates.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace oracle;
using Eigen::Vector3d;
using pcl::manifold::crossesFirst;
using pcl::manifold::isOutsideBall;
using pcl::manifold::nearer;

// A point as far from p as from q, but for rounding.
TEST (Nearer, ToTwoPoints)
{
  int counts[3] = {0, 0, 0};
  for (std::uint64_t round = 0; round < 20000; ++round) {
    Random random (round);
    const Vector3d x = anyPoint (random);
    const Vector3d d = anyPoint (random);
    const Vector3d e (d.y (), d.z (), d.x ());
    const double size = round % 3 == 0 ? std::ldexp (1.0, random.integer (-1000, 900)) : 1.0;
    const Vector3d point = size * nudged (x, random);
    const Vector3d p = size * nudged (x + d, random);
    const Vector3d q = size * nudged (x + e, random);
    const auto to_p = fromTo<Rational> (point, p);
    const auto to_q = fromTo<Rational> (point, q);
    const int expected = sign<Rational> (dot (to_p, to_p) - dot (to_q, to_q));
    ASSERT_EQ (nearer (point, p, q), expected);
    ASSERT_EQ (nearer (point, q, p), -expected);
    ++counts[1 + expected];
  }
  EXPECT_EQ (nearer ({0, 0, 0}, {1, 2, 3}, {3, 1, 2}), 0);
  EXPECT_EQ (nearer ({1, 0, 0}, {0x1p-90, 0, 0}, {2, 0, 0}), -1) << "the difference rounds to 1";
  EXPECT_EQ (nearer ({1, 0, 0}, {-0x1p-90, 0, 0}, {2, 0, 0}), 1);
  EXPECT_GT (counts[0], 5000);
  EXPECT_GT (counts[2], 5000);
}

// The Voronoi cell of p is left into two others at once, but for rounding.
TEST (CrossesFirst, OfTwoBisectors)
{
  int counts[3] = {0, 0, 0};
  for (std::uint64_t round = 0; round < 20000; ++round) {
    Random random (round);
    const Vector3d crossing = anyPoint (random);
    const auto onSphere = [&] { return nudged (crossing + anyPoint (random).normalized (), random); };
    const Vector3d p = onSphere ();
    const Vector3d q = onSphere ();
    const Vector3d r = round % 7 == 0 ? q : onSphere ();
    const Vector3d d = anyPoint (random);
    const Vector3d from = crossing - random.uniform () * d;
    const Vector3d to = crossing + random.uniform () * d;
    // How much farther a point is from s than from p.
    const auto excess = [&p] (const Vector3d& x, const Vector3d& s) {
      const auto to_p = fromTo<Rational> (x, p);
      const auto to_s = fromTo<Rational> (x, s);
      return Rational (dot (to_s, to_s) - dot (to_p, to_p));
    };
    if (excess (from, q) < 0 || excess (from, r) < 0 || excess (to, q) >= 0 || excess (to, r) >= 0)
      continue;
    const auto place = [&] (const Vector3d& s) {
      return Rational (excess (from, s) / (excess (from, s) - excess (to, s)));
    };
    const int expected = sign<Rational> (place (q) - place (r));
    ASSERT_EQ (crossesFirst (from, to, p, q, r), expected);
    ++counts[1 + expected];
  }
  EXPECT_GT (counts[0], 500);
  EXPECT_GT (counts[1], 100);
  EXPECT_GT (counts[2], 500);
}

TEST (IsOutsideBall, OfADiameter)
{
  int counts[2] = {0, 0};
  for (std::uint64_t round = 0; round < 20000; ++round) {
    Random random (round);
    const Vector3d center = anyPoint (random);
    const Vector3d d = anyPoint (random);
    const Vector3d e (d.z (), d.x (), d.y ());
    const Vector3d p = nudged (center + d, random);
    const Vector3d q = nudged (center - d, random);
    const Vector3d x = nudged (center + e, random);
    const bool expected = dot (fromTo<Rational> (x, p), fromTo<Rational> (x, q)) > 0;
    ASSERT_EQ (isOutsideBall (x, p, q), expected);
    ++counts[expected ? 1 : 0];
  }
  EXPECT_FALSE (isOutsideBall ({0, 1, 0}, {-1, 0, 0}, {1, 0, 0})) << "on the sphere";
  EXPECT_GT (counts[0], 5000);
  EXPECT_GT (counts[1], 5000);
}

} // namespace
