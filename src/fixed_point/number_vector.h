#pragma once

#include <Eigen/Core>

#include <array>

namespace pcl {
namespace manifold {

/** The difference of two doubles as a filtered or as an exact number. */
template <typename Number>
Number differenceOf (double x, double y);

/** Vectors of these numbers. */
template <typename Number>
using NumberVector = std::array<Number, 3>;

/** x - y */
template <typename Number>
NumberVector<Number>
difference (const Eigen::Vector3d& x, const Eigen::Vector3d& y)
{
  return {differenceOf<Number> (x[0], y[0]), differenceOf<Number> (x[1], y[1]),
          differenceOf<Number> (x[2], y[2])};
}

template <typename Number>
Number
dot (const NumberVector<Number>& u, const NumberVector<Number>& v)
{
  return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}

/** |x - v|^2 - |x|^2: how much farther x is from v than from the origin. Linear in x but for a constant. */
template <typename Number>
Number
excess (const NumberVector<Number>& v, const NumberVector<Number>& x)
{
  return dot<Number> (v, {v[0] - (x[0] + x[0]), v[1] - (x[1] + x[1]), v[2] - (x[2] + x[2])});
}

template <typename Number>
Number
determinant (const Number& a, const Number& b, const Number& c, const Number& d)
{
  return a * d - b * c;
}

/** How the corners of a flat piece, relative to a sample p, lie to the Voronoi face between p and another
 * sample q: `f` is their excess over q relative to p. With the excess g over a third sample, f and g are
 * coordinates of a plane that sees the Voronoi edge of the three samples as its origin. The piece meets the
 * line of the edge where its image has the origin in it, which is the case if the three weights have one
 * sign: they are the barycentric coordinates of the crossing up to a factor. */
template <typename Number>
struct FaceImage
{
  Eigen::Vector3d base;
  std::array<NumberVector<Number>, 3> corners;
  NumberVector<Number> f;

  FaceImage (const std::array<Eigen::Vector3d, 3>& piece, const Eigen::Vector3d& p, const Eigen::Vector3d& q)
    : base (p)
  {
    for (int i = 0; i < 3; ++i)
      corners[i] = difference<Number> (piece[i], p);
    f = excesses (q);
  }

  /** The excess of each corner over a sample. */
  NumberVector<Number> excesses (const Eigen::Vector3d& sample) const
  {
    const NumberVector<Number> v = difference<Number> (sample, base);
    return {excess (v, corners[0]), excess (v, corners[1]), excess (v, corners[2])};
  }

  Number weight (const NumberVector<Number>& g, int i) const
  {
    const int j = i == 2 ? 0 : i + 1;
    const int k = i == 0 ? 2 : i - 1;
    return determinant (f[j], f[k], g[j], g[k]);
  }

  NumberVector<Number> weights (const NumberVector<Number>& g) const
  {
    return {weight (g, 0), weight (g, 1), weight (g, 2)};
  }
};

} // namespace manifold
} // namespace pcl
