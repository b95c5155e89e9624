#pragma once

#include "oracle_random.h"

#include <pcl/manifold/delaunay_complex.h>
#include <pcl/manifold/sample_set.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <set>
#include <vector>

namespace oracle {

/** \brief Clouds of distinct points with integer coordinates of at most 18 bits, on which predicates and
 * Voronoi vertices can be computed exactly, and on which every kind of degeneracy is easy to make. */
enum class Lattice
{
  GENERIC,      ///< anywhere: no degeneracy to be expected
  FEW,          ///< 1 to 5 points of a small cube
  CROWDED,      ///< of a small cube: many coplanar and cospherical ones
  GRID,         ///< a full regular grid
  FLAT_GRID,    ///< a full regular grid in a plane
  PLANE,        ///< anywhere in a plane, which is not one of the axes'
  SHEET,        ///< nearly in a plane: heights of a few units on a wide base
  COSPHERICAL,  ///< on a sphere, some with its centre
  LINE,         ///< collinear
  LINE_AND_ONE, ///< collinear but for one point
  STRETCHED,    ///< extents of very different size
  CLUSTERS,     ///< two far from each other
  CURVE,        ///< along a helix
  SPHERE,       ///< rounded from a sphere
  BALL,         ///< in a ball
  COUNT
};

using Point = std::array<int, 3>;

inline Point
onHelix (Random& random)
{
  const double t = random.uniform (0.0, 12.0);
  return {static_cast<int> (60000 * std::cos (t)), static_cast<int> (60000 * std::sin (t)),
          static_cast<int> (8000 * t)};
}

inline Point
roundedDirection (Random& random, double radius)
{
  Eigen::Vector3d v;
  do
    v = Eigen::Vector3d (random.uniform (-1, 1), random.uniform (-1, 1), random.uniform (-1, 1));
  while (v.norm () > 1.0 || v.norm () < 0.1);
  v = radius * v.normalized ();
  return {static_cast<int> (v.x ()), static_cast<int> (v.y ()), static_cast<int> (v.z ())};
}

/** \brief All integer points at the square root of 101 from the origin: 168 of them. */
inline std::vector<Point>
cosphericalPoints ()
{
  std::vector<Point> points;
  for (int x = -10; x <= 10; ++x)
    for (int y = -10; y <= 10; ++y)
      for (int z = -10; z <= 10; ++z)
        if (x * x + y * y + z * z == 101)
          points.push_back ({x, y, z});
  return points;
}

inline Point
latticePoint (Lattice kind, Random& random)
{
  const auto cube = [&random] (int x, int y, int z) -> Point {
    return {random.integer (-x, x), random.integer (-y, y), random.integer (-z, z)};
  };
  switch (kind) {
    case Lattice::FEW:
      return cube (2, 2, 2);
    case Lattice::CROWDED:
      return cube (3, 3, 3);
    case Lattice::PLANE: {
      const int i = random.integer (-9, 9);
      const int j = random.integer (-9, 9);
      return {2 * i + j, i - 3 * j, 5 * j - i};
    }
    case Lattice::SHEET:
      return cube (2000, 2000, 2);
    case Lattice::COSPHERICAL: {
      static const std::vector<Point> points = cosphericalPoints ();
      const int i = random.index (static_cast<int> (points.size ()) + 3);
      return i < static_cast<int> (points.size ()) ? points[i] : Point{0, 0, 0};
    }
    case Lattice::LINE: {
      const int i = random.integer (-40, 40);
      return {3 * i, -2 * i, 7 * i};
    }
    case Lattice::STRETCHED:
      return cube (100000, 300, 1);
    case Lattice::CLUSTERS: {
      const Point p = cube (50, 50, 50);
      return random.coin () ? p : Point{p[0] + 100000, p[1] + 70000, p[2]};
    }
    case Lattice::CURVE:
      return onHelix (random);
    case Lattice::SPHERE:
      return roundedDirection (random, 100000);
    case Lattice::BALL:
      return roundedDirection (random, 100000 * std::cbrt (random.uniform ()));
    default:
      return cube (100000, 100000, 100000);
  }
}

/** \brief A cloud of about the given number of points (fewer where the kind has not so many, few for FEW), in
 * random order. */
inline Eigen::Matrix3Xd
latticeCloud (Lattice kind, int size, std::uint64_t seed)
{
  Random random (seed * 64 + static_cast<std::uint64_t> (kind));
  std::vector<Point> points;
  if (kind == Lattice::GRID || kind == Lattice::FLAT_GRID) {
    const int side =
      kind == Lattice::GRID ? static_cast<int> (std::cbrt (size)) : static_cast<int> (std::sqrt (size));
    const int nx = std::max (1, side + random.index (2));
    const int ny = std::max (1, side + random.index (2));
    const int nz = kind == Lattice::GRID ? std::max (1, side + random.index (2)) : 1;
    for (int x = 0; x < nx; ++x)
      for (int y = 0; y < ny; ++y)
        for (int z = 0; z < nz; ++z)
          points.push_back ({x, 2 * y, z});
  } else {
    if (kind == Lattice::FEW)
      size = 1 + random.index (5);
    std::set<Point> distinct;
    for (int i = 0; i < 4 * size && static_cast<int> (distinct.size ()) < size; ++i) {
      const Point p = latticePoint (kind, random);
      if (distinct.insert (p).second)
        points.push_back (p);
    }
    if (kind == Lattice::LINE_AND_ONE) {
      for (std::size_t i = 0; i < points.size (); ++i)
        points[i] = {static_cast<int> (i * i), static_cast<int> (i * i), 0};
      points.push_back ({3, 1, 2});
    }
  }
  for (std::size_t i = points.size (); i > 1; --i)
    std::swap (points[i - 1], points[static_cast<std::size_t> (random.index (static_cast<int> (i)))]);
  Eigen::Matrix3Xd cloud (3, static_cast<Eigen::Index> (points.size ()));
  for (std::size_t i = 0; i < points.size (); ++i)
    cloud.col (static_cast<Eigen::Index> (i)) = Eigen::Vector3i (points[i].data ()).cast<double> ();
  return cloud;
}

/** \brief Distinct finite points as they are: no shift, no scale, no thinning. */
inline std::shared_ptr<const pcl::manifold::SampleSet>
asSamples (const Eigen::Matrix3Xd& points)
{
  auto samples = std::make_shared<pcl::manifold::SampleSet> ();
  samples->points = points;
  for (Eigen::Index i = 0; i < points.cols (); ++i) {
    samples->input_index.push_back (static_cast<pcl::index_t> (i));
    samples->sample_of.push_back (static_cast<std::int32_t> (i));
  }
  return samples;
}

inline std::shared_ptr<const pcl::manifold::DelaunayComplex>
complexOf (const Eigen::Matrix3Xd& points)
{
  return pcl::manifold::computeDelaunayComplex (asSamples (points), 1);
}

/** \brief Calls body (cloud, kind) for clouds of every kind, the degenerate ones among them. */
template <typename Body>
void
forEachLattice (int rounds, int smallest, int largest, const Body& body)
{
  for (int round = 0; round < rounds; ++round)
    for (int kind = 0; kind < static_cast<int> (Lattice::COUNT); ++kind) {
      Random random (static_cast<std::uint64_t> (round));
      const int size = random.integer (smallest, largest);
      body (latticeCloud (static_cast<Lattice> (kind), size, static_cast<std::uint64_t> (round)), kind);
    }
}

} // namespace oracle
