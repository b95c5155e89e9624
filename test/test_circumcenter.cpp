// Circumcentres and normals against rational arithmetic.
#include "oracle_exact.h"
#include "oracle_random.h"

#include "delaunay/circumcenter.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace oracle;
using pcl::manifold::circumcenter;
using pcl::manifold::unitNormal;
using Corners = std::array<Eigen::Vector3d, 4>;

// The centre over the largest of its coordinates and 1, so that it fits in doubles whatever its size.
struct Expected
{
  Eigen::Vector3d scaled;
  Rational scale;
};

Expected
expectedCenter (const Eigen::Vector3d& a, const Center<Rational>& center)
{
  Vector<Rational> c;
  Rational scale = 1;
  for (int axis = 0; axis < 3; ++axis) {
    c[axis] = Rational (a[axis]) + center.numerator[axis] / (2 * center.denominator);
    scale = std::max<Rational> (scale, abs (c[axis]));
  }
  Expected expected{{}, scale};
  for (int axis = 0; axis < 3; ++axis)
    expected.scaled[axis] = static_cast<Rational> (c[axis] / scale).convert_to<double> ();
  return expected;
}

// Right to seven digits of the distance of the centre from the corner a, or rather to a rounding error of its
// coordinates where those are larger.
void
expectCenter (const Eigen::Vector3d& result, const Eigen::Vector3d& a, const Center<Rational>& center)
{
  ASSERT_TRUE (result.allFinite ());
  Rational squared_error = 0;
  Rational squared_distance = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const Rational offset = center.numerator[axis] / (2 * center.denominator);
    const Rational error = Rational (result[axis]) - Rational (a[axis]) - offset;
    squared_error += error * error;
    squared_distance += offset * offset;
  }
  const Rational rounding = Rational (0x1p-50) * Rational (result.cwiseAbs ().maxCoeff ());
  EXPECT_TRUE (squared_error <= Rational (1e-14) * squared_distance + rounding * rounding)
    << "relative error "
    << std::sqrt (static_cast<Rational> (squared_error / squared_distance).convert_to<double> ());
}

Center<Rational>
exactCenter (const Corners& p)
{
  return centerOf (fromTo<Rational> (p[0], p[1]), fromTo<Rational> (p[0], p[2]),
                   fromTo<Rational> (p[0], p[3]));
}

void
expectTetrahedron (const Corners& p)
{
  const Center<Rational> center = exactCenter (p);
  if (center.denominator == 0)
    return;
  const Eigen::Vector3d result = circumcenter (p[0], p[1], p[2], p[3]);
  ASSERT_TRUE (result.allFinite ()) << p[0] << "\n" << p[1] << "\n" << p[2] << "\n" << p[3];
  // Beyond the range of squares of doubles only the direction is kept.
  const Expected expected = expectedCenter (p[0], center);
  if (expected.scale < Rational (1e140))
    expectCenter (result, p[0], center);
  else
    EXPECT_LT ((result.stableNormalized () - expected.scaled.normalized ()).norm (), 1e-7);
}

void
expectTriangle (const Corners& p)
{
  const Vector<Rational> u = fromTo<Rational> (p[0], p[1]);
  const Vector<Rational> v = fromTo<Rational> (p[0], p[2]);
  const Vector<Rational> n = cross (u, v);
  if (isZero (n))
    return;
  const Center<Rational> center = centerOf (u, v);
  if (expectedCenter (p[0], center).scale < Rational (1e140))
    expectCenter (circumcenter (p[0], p[1], p[2]), p[0], center);
  Rational largest = 0;
  for (const Rational& x : n)
    largest = std::max<Rational> (largest, abs (x));
  const Eigen::Vector3d normal = rounded (n, largest).cast<double> ().normalized ();
  EXPECT_LT ((unitNormal (p[0], p[1], p[2]) - normal).norm (), 1e-7);
}

Corners
randomCorners (Random& random)
{
  Corners p;
  for (Eigen::Vector3d& corner : p)
    corner = Eigen::Vector3d (random.uniform (-1, 1), random.uniform (-1, 1), random.uniform (-1, 1));
  return p;
}

void
expectBoth (const Corners& p)
{
  expectTetrahedron (p);
  expectTriangle (p);
}

TEST (Circumcenter, OfACornerOfACube)
{
  const Eigen::Vector3d o (0, 0, 0), x (2, 0, 0), y (0, 2, 0), z (0, 0, 2);
  EXPECT_TRUE (circumcenter (o, x, y, z) == Eigen::Vector3d (1, 1, 1));
  EXPECT_TRUE (circumcenter (o, x, y) == Eigen::Vector3d (1, 1, 0));
  EXPECT_TRUE (unitNormal (o, x, y) == Eigen::Vector3d (0, 0, 1));
}

TEST (Circumcenter, OfFlatTetrahedraOfEveryThickness)
{
  for (int round = 0; round < 500; ++round) {
    Random random (static_cast<std::uint64_t> (round));
    Corners p = randomCorners (random);
    const int thickness = random.index (round % 5 == 0 ? 1080 : 80);
    for (Eigen::Vector3d& corner : p)
      corner.z () = std::ldexp (corner.z (), -thickness);
    expectBoth (p);
  }
}

// Four points of a circle, rounded: the determinant is all rounding.
TEST (Circumcenter, OfRoundedCircles)
{
  for (int round = 0; round < 2000; ++round) {
    Random random (static_cast<std::uint64_t> (round));
    const Corners axes = randomCorners (random);
    Corners p;
    for (Eigen::Vector3d& corner : p) {
      const double t = random.uniform (0, 6.28);
      corner = axes[0] + std::cos (t) * axes[1] + std::sin (t) * axes[2];
    }
    expectBoth (p);
  }
}

TEST (Circumcenter, OfNeedles)
{
  for (int round = 0; round < 2000; ++round) {
    Random random (static_cast<std::uint64_t> (round));
    const double width = std::ldexp (1.0, -random.index (60));
    Corners p = randomCorners (random);
    for (Eigen::Vector3d& corner : p)
      corner = Eigen::Vector3d (1, 2, 3) * corner.x () + width * corner;
    expectBoth (p);
  }
}

// Small ones in a large set: squares and products of their edges underflow.
TEST (Circumcenter, OfEverySize)
{
  for (int round = 0; round < 200; ++round) {
    Random random (static_cast<std::uint64_t> (round));
    Corners p = randomCorners (random);
    const double size = std::ldexp (1.0, -random.index (1000));
    const bool far = random.coin ();
    for (int k = 0; k < 4; ++k)
      p[k] = k == 3 && far ? p[k] : Eigen::Vector3d (size * p[k]);
    expectBoth (p);
  }
}

TEST (Circumcenter, FarFromTheOrigin)
{
  for (int round = 0; round < 1000; ++round) {
    Random random (static_cast<std::uint64_t> (round));
    Corners p = randomCorners (random);
    const Eigen::Vector3d offset = std::ldexp (1.0, random.index (50)) * Eigen::Vector3d (1, -0.7, 0.3);
    for (Eigen::Vector3d& corner : p)
      corner += offset;
    expectBoth (p);
  }
}

} // namespace
