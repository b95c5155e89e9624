#pragma once

#include <Eigen/Core>

// GCC takes numbers of Boost's that are small for uninitialized large ones.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#include <boost/multiprecision/cpp_int.hpp>
#pragma GCC diagnostic pop

#include <array>
#include <cstdint>

/** \file
 * Predicates and circumcentres without rounding: in 128 bits for the lattice clouds, in rational numbers for
 * any doubles. */

namespace oracle {

using Integer = boost::multiprecision::int128_t;
using Rational = boost::multiprecision::cpp_rational;

template <typename Number>
using Vector = std::array<Number, 3>;

template <typename Number>
Number
exact (double x)
{
  return Number (x);
}

template <>
inline Integer
exact<Integer> (double x)
{
  return {static_cast<std::int64_t> (x)};
}

template <typename Number>
int
sign (const Number& x)
{
  return x < 0 ? -1 : (x > 0 ? 1 : 0);
}

template <typename Number>
Vector<Number>
exact (const Eigen::Vector3d& p)
{
  return {exact<Number> (p.x ()), exact<Number> (p.y ()), exact<Number> (p.z ())};
}

/** \brief b - a. */
template <typename Number>
Vector<Number>
fromTo (const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  const Vector<Number> u = exact<Number> (a);
  const Vector<Number> v = exact<Number> (b);
  return {Number (v[0] - u[0]), Number (v[1] - u[1]), Number (v[2] - u[2])};
}

template <typename Number>
Number
dot (const Vector<Number>& u, const Vector<Number>& v)
{
  return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}

template <typename Number>
Vector<Number>
cross (const Vector<Number>& u, const Vector<Number>& v)
{
  return {Number (u[1] * v[2] - u[2] * v[1]), Number (u[2] * v[0] - u[0] * v[2]),
          Number (u[0] * v[1] - u[1] * v[0])};
}

template <typename Number>
bool
isZero (const Vector<Number>& u)
{
  return u[0] == 0 && u[1] == 0 && u[2] == 0;
}

/** \brief Sign of det (b - a, c - a, d - a). */
template <typename Number>
int
orientation (const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
             const Eigen::Vector3d& d)
{
  return sign<Number> (dot (fromTo<Number> (a, b), cross (fromTo<Number> (a, c), fromTo<Number> (a, d))));
}

/** \brief The point at the same distance from the origin and from u, v and w: numerator / (2 denominator).
 * The denominator is zero where there is no such point. */
template <typename Number>
struct Center
{
  Vector<Number> numerator;
  Number denominator;
};

template <typename Number>
Center<Number>
centerOf (const Vector<Number>& u, const Vector<Number>& v, const Vector<Number>& w)
{
  const Vector<Number> vw = cross (v, w);
  const Vector<Number> wu = cross (w, u);
  const Vector<Number> uv = cross (u, v);
  const Number uu = dot (u, u);
  const Number vv = dot (v, v);
  const Number ww = dot (w, w);
  Center<Number> center;
  center.denominator = dot (u, vw);
  for (int axis = 0; axis < 3; ++axis)
    center.numerator[axis] = uu * vw[axis] + vv * wu[axis] + ww * uv[axis];
  return center;
}

/** \brief As above for the point in the plane of the origin, u and v. */
template <typename Number>
Center<Number>
centerOf (const Vector<Number>& u, const Vector<Number>& v)
{
  const Vector<Number> n = cross (u, v);
  const Vector<Number> vn = cross (v, n);
  const Vector<Number> nu = cross (n, u);
  const Number uu = dot (u, u);
  const Number vv = dot (v, v);
  Center<Number> center;
  center.denominator = dot (n, n);
  for (int axis = 0; axis < 3; ++axis)
    center.numerator[axis] = uu * vn[axis] + vv * nu[axis];
  return center;
}

/** \brief How much nearer e is to the centre than the origin is: 1 nearer, 0 as far, -1 farther. */
template <typename Number>
int
sideOfSphere (const Center<Number>& center, const Vector<Number>& e)
{
  const Number difference = dot (e, center.numerator) - dot (e, e) * center.denominator;
  return sign<Number> (difference) * sign<Number> (center.denominator);
}

template <typename Number>
Eigen::Matrix<long double, 3, 1>
rounded (const Vector<Number>& numerator, const Number& denominator)
{
  Eigen::Matrix<long double, 3, 1> result;
  for (int axis = 0; axis < 3; ++axis)
    result[axis] =
      numerator[axis].template convert_to<long double> () / denominator.template convert_to<long double> ();
  return result;
}

} // namespace oracle
