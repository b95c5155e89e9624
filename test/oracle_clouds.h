#pragma once

#include "oracle_lattice.h"

#include <Eigen/Geometry>

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace oracle {

/** \brief Clouds as they come: of curves, surfaces and solids, of all of them together, and of nothing in
 * particular; some with duplicates, points that are not finite, far from the origin, very large or very
 * small. */
struct NamedCloud
{
  std::string name;
  std::function<Eigen::Vector3d (Random&)> point;
};

inline Eigen::Vector3d
inCube (Random& random)
{
  return {random.uniform (-1, 1), random.uniform (-1, 1), random.uniform (-1, 1)};
}

inline Eigen::Vector3d
onSphere (Random& random)
{
  Eigen::Vector3d v;
  do
    v = inCube (random);
  while (v.norm () > 1.0 || v.norm () < 0.1);
  return v.normalized ();
}

inline Eigen::Vector3d
inBall (Random& random)
{
  return std::cbrt (random.uniform ()) * onSphere (random);
}

inline Eigen::Vector3d
onTorus (Random& random)
{
  const double a = random.uniform (0, 2 * M_PI);
  const double b = random.uniform (0, 2 * M_PI);
  return {(1 + 0.4 * std::cos (b)) * std::cos (a), (1 + 0.4 * std::cos (b)) * std::sin (a),
          0.4 * std::sin (b)};
}

inline Eigen::Vector3d
onCircle (Random& random)
{
  const double a = random.uniform (0, 2 * M_PI);
  return {std::cos (a), std::sin (a), 0};
}

inline Eigen::Vector3d
onSheet (Random& random)
{
  const double x = random.uniform (-1, 1);
  const double y = random.uniform (-1, 1);
  return {x, y, 0.2 * std::sin (3 * x) * std::cos (2 * y)};
}

inline const std::vector<NamedCloud>&
namedClouds ()
{
  using Eigen::Vector3d;
  static const std::vector<NamedCloud> clouds{
    {"cube", inCube},
    {"sphere", onSphere},
    {"ball", inBall},
    {"torus", onTorus},
    {"circle", onCircle},
    {"sheet", onSheet},
    {"helix",
     [] (Random& random) {
       const double t = random.uniform (0, 9);
       return Vector3d (std::cos (t), std::sin (t), 0.2 * t);
     }},
    {"plane", [] (Random& random) { return Vector3d (random.uniform (-1, 1), random.uniform (-1, 1), 0); }},
    {"noisy plane",
     [] (Random& random) {
       return Vector3d (random.uniform (-1, 1), random.uniform (-1, 1), 0.02 * random.uniform (-1, 1));
     }},
    {"noisy sphere",
     [] (Random& random) {
       const Vector3d v = onSphere (random);
       return Vector3d ((1 + 0.1 * random.uniform (-1, 1)) * v);
     }},
    {"segment", [] (Random& random) { return Vector3d (random.uniform () * Vector3d (1, 2, 3)); }},
    {"crossing segments",
     [] (Random& random) { return Vector3d (random.uniform (-1, 1) * Vector3d::Unit (random.index (3))); }},
    {"crossing planes",
     [] (Random& random) {
       Vector3d v = inCube (random);
       v[random.index (3)] = 0;
       return v;
     }},
    {"touching spheres",
     [] (Random& random) {
       const Vector3d v = onSphere (random);
       return Vector3d (v + (random.coin () ? 1.0 : -1.0) * Vector3d::UnitX ());
     }},
    {"nested spheres",
     [] (Random& random) { return Vector3d ((random.coin () ? 1.0 : 0.5) * onSphere (random)); }},
    {"sphere around a ball",
     [] (Random& random) { return random.coin () ? onSphere (random) : Vector3d (0.5 * inBall (random)); }},
    {"ball on a sheet",
     [] (Random& random) {
       return random.coin () ? onSheet (random) : Vector3d (0.5 * inBall (random) + Vector3d (0, 0, 0.4));
     }},
    {"ball and circle",
     [] (Random& random) { return random.coin () ? onCircle (random) : Vector3d (0.6 * inBall (random)); }},
    {"scene",
     [] (Random& random) {
       switch (random.index (4)) {
         case 0:
           return onSphere (random);
         case 1:
           return Vector3d (inBall (random) + Vector3d (3, 0, 0));
         case 2:
           return Vector3d (onCircle (random) + Vector3d (0, 3, 0));
         default:
           return Vector3d (onSheet (random) + Vector3d (0, 0, 3));
       }
     }},
    {"two densities",
     [] (Random& random) {
       const Vector3d v = onSphere (random);
       return v.x () > 0 ? v : Vector3d (v.cwiseProduct (Vector3d (1, 0.01, 0.01)));
     }},
    {"flat box",
     [] (Random& random) { return Vector3d (inCube (random).cwiseProduct (Vector3d (1, 1, 1e-6))); }},
    {"needle",
     [] (Random& random) { return Vector3d (inCube (random).cwiseProduct (Vector3d (1, 1e-6, 1e-9))); }},
  };
  return clouds;
}

/** \brief What happens to clouds on their way: nothing, most often. */
inline void
soil (Eigen::Matrix3Xd& cloud, Random& random)
{
  switch (random.index (8)) {
    case 0: // exact duplicates
      for (Eigen::Index i = 1; i < cloud.cols (); i += 3)
        cloud.col (i) = cloud.col (random.index (static_cast<int> (i)));
      break;
    case 1:
      for (Eigen::Index i = 0; i < cloud.cols (); i += 5)
        cloud (random.index (3), i) = random.coin () ? std::numeric_limits<double>::quiet_NaN ()
                                                     : std::numeric_limits<double>::infinity ();
      break;
    case 2: // on a raster
      cloud = (cloud * 6.0).array ().round ();
      break;
    case 3:
      cloud *= random.coin () ? 1e30 : 1e-30;
      break;
    case 4:
      cloud.colwise () += Eigen::Vector3d (5e5, 4.5e6, 100);
      break;
    default:
      break;
  }
}

/** \brief Calls body (cloud, name) for clouds of every kind. The first rounds have a few points only. */
template <typename Body>
void
forEachCloud (int rounds, int largest, const Body& body)
{
  for (int round = 0; round < rounds; ++round) {
    Random random (static_cast<std::uint64_t> (round) + 1000);
    for (const NamedCloud& named : namedClouds ()) {
      const int size = round < 6 ? round + 1 : random.integer (5, largest);
      Eigen::Matrix3Xd cloud (3, size);
      for (Eigen::Index i = 0; i < cloud.cols (); ++i)
        cloud.col (i) = named.point (random);
      soil (cloud, random);
      body (cloud, named.name + ", round " + std::to_string (round));
    }
    for (int kind = 0; kind < static_cast<int> (Lattice::COUNT); ++kind)
      body (latticeCloud (static_cast<Lattice> (kind), random.integer (1, largest),
                          static_cast<std::uint64_t> (round)),
            "lattice " + std::to_string (kind) + ", round " + std::to_string (round));
  }
}

} // namespace oracle
