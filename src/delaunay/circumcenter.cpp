#include "delaunay/circumcenter.h"

#include <boost/multiprecision/cpp_int.hpp>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>

namespace pcl {
namespace manifold {

namespace {

// Below this share of its largest terms a determinant of doubles has lost about eight of its sixteen digits.
constexpr double CANCELLATION = 1e-8;
// Below these a determinant and a normal come from edges whose products underflow further on.
constexpr double TINY_DETERMINANT = 1e-200;
constexpr double TINY_NORMAL = 1e-100;
// No centre is farther away than this, so that its square is finite.
constexpr double FARTHEST = 1e150;

using Rational = boost::multiprecision::cpp_rational;
using ExactVector = std::array<Rational, 3>;

ExactVector
difference (const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  return {Rational (a.x ()) - Rational (b.x ()), Rational (a.y ()) - Rational (b.y ()),
          Rational (a.z ()) - Rational (b.z ())};
}

ExactVector
cross (const ExactVector& u, const ExactVector& v)
{
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

Rational
dot (const ExactVector& u, const ExactVector& v)
{
  return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}

Rational
largestComponent (const ExactVector& u)
{
  Rational largest = 0;
  for (const Rational& component : u)
    largest = std::max<Rational> (largest, abs (component));
  return largest;
}

// base + numerator / denominator, rounded once.
Eigen::Vector3d
rounded (const Eigen::Vector3d& base, const ExactVector& numerator, const Rational& denominator)
{
  ExactVector exact;
  for (int axis = 0; axis < 3; ++axis)
    exact[axis] = Rational (base[axis]) + numerator[axis] / denominator;
  const Rational largest = largestComponent (exact);
  Eigen::Vector3d result;
  for (int axis = 0; axis < 3; ++axis)
    result[axis] = largest > FARTHEST
                     ? static_cast<Rational> (exact[axis] / largest).convert_to<double> () * FARTHEST
                     : exact[axis].convert_to<double> ();
  return result;
}

Eigen::Vector3d
exactCircumcenter (const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                   const Eigen::Vector3d& d)
{
  const ExactVector u = difference (b, a);
  const ExactVector v = difference (c, a);
  const ExactVector w = difference (d, a);
  const ExactVector vw = cross (v, w);
  const ExactVector wu = cross (w, u);
  const ExactVector uv = cross (u, v);
  const Rational uu = dot (u, u);
  const Rational vv = dot (v, v);
  const Rational ww = dot (w, w);
  ExactVector numerator;
  for (int axis = 0; axis < 3; ++axis)
    numerator[axis] = uu * vw[axis] + vv * wu[axis] + ww * uv[axis];
  return rounded (a, numerator, 2 * dot (u, vw));
}

Eigen::Vector3d
exactCircumcenter (const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c)
{
  const ExactVector u = difference (b, a);
  const ExactVector v = difference (c, a);
  const ExactVector n = cross (u, v);
  const ExactVector vn = cross (v, n);
  const ExactVector nu = cross (n, u);
  const Rational uu = dot (u, u);
  const Rational vv = dot (v, v);
  ExactVector numerator;
  for (int axis = 0; axis < 3; ++axis)
    numerator[axis] = uu * vn[axis] + vv * nu[axis];
  return rounded (a, numerator, 2 * dot (n, n));
}

} // namespace

Eigen::Vector3d
circumcenter (const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
              const Eigen::Vector3d& d)
{
  const Eigen::Vector3d u = b - a;
  const Eigen::Vector3d v = c - a;
  const Eigen::Vector3d w = d - a;
  const double determinant = u.dot (v.cross (w));
  const double magnitude =
    u.cwiseAbs ().dot (Eigen::Vector3d (std::abs (v.y () * w.z ()) + std::abs (v.z () * w.y ()),
                                        std::abs (v.z () * w.x ()) + std::abs (v.x () * w.z ()),
                                        std::abs (v.x () * w.y ()) + std::abs (v.y () * w.x ())));
  if (!(std::abs (determinant) > std::max (CANCELLATION * magnitude, TINY_DETERMINANT)))
    return exactCircumcenter (a, b, c, d);
  return a +
         (u.squaredNorm () * v.cross (w) + v.squaredNorm () * w.cross (u) + w.squaredNorm () * u.cross (v)) /
           (2.0 * determinant);
}

Eigen::Vector3d
circumcenter (const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c)
{
  const Eigen::Vector3d u = b - a;
  const Eigen::Vector3d v = c - a;
  const Eigen::Vector3d n = u.cross (v);
  if (!(n.norm () > std::max (CANCELLATION * u.norm () * v.norm (), TINY_NORMAL)))
    return exactCircumcenter (a, b, c);
  return a + (u.squaredNorm () * v.cross (n) + v.squaredNorm () * n.cross (u)) / (2.0 * n.squaredNorm ());
}

Eigen::Vector3d
unitNormal (const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c)
{
  const Eigen::Vector3d n = (b - a).cross (c - a);
  if (n.norm () > std::max (CANCELLATION * (b - a).norm () * (c - a).norm (), TINY_NORMAL))
    return n.normalized ();
  const ExactVector exact = cross (difference (b, a), difference (c, a));
  // Scaled by its largest component before rounding, so that it cannot underflow.
  return rounded (Eigen::Vector3d::Zero (), exact, largestComponent (exact)).normalized ();
}

} // namespace manifold
} // namespace pcl
