#include <generate/scene_parts.h>

#include <boost/math/constants/constants.hpp>

#include <cmath>

namespace generate {

using boost::math::constants::pi;
using Eigen::Vector3d;

void
addQuad (RayScene& scene, const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& d,
         Truth what)
{
  scene.addTriangle (a, b, c, what);
  scene.addTriangle (a, c, d, what);
}

void
addWire (RayScene& scene, const Vector3d& from, const Vector3d& to, double sag)
{
  constexpr int PIECES = 48;
  constexpr double RADIUS = 0.012;
  const auto at = [&] (int piece) -> Vector3d {
    const double t = static_cast<double> (piece) / PIECES;
    return from + t * (to - from) - 4.0 * sag * t * (1.0 - t) * Vector3d::UnitZ ();
  };
  for (int piece = 0; piece < PIECES; ++piece)
    scene.addRod (at (piece), at (piece + 1), RADIUS, truth (1, LidarClass::WIRE));
}

void
addHouse (RayScene& scene, const Vector3d& foot, double angle, double length, double width, double eaves,
          double ridge)
{
  constexpr double OVERHANG = 0.4;
  const Truth building = truth (2, LidarClass::BUILDING);
  const auto place = [&] (double along, double across, double up) -> Vector3d {
    return {foot.x () + along * std::cos (angle) - across * std::sin (angle),
            foot.y () + along * std::sin (angle) + across * std::cos (angle), foot.z () + up};
  };
  const double l = 0.5 * length, w = 0.5 * width, below = -2.0; // the ground under a house is not flat
  for (const double side : {-1.0, 1.0}) {
    addQuad (scene, place (-l, side * w, below), place (l, side * w, below), place (l, side * w, eaves),
             place (-l, side * w, eaves), building);
    addQuad (scene, place (side * l, -w, below), place (side * l, w, below), place (side * l, w, eaves),
             place (side * l, -w, eaves), building);
    scene.addTriangle (place (side * l, -w, eaves), place (side * l, w, eaves), place (side * l, 0.0, ridge),
                       building);
    const double drop = eaves - OVERHANG * (ridge - eaves) / w, out = side * (w + OVERHANG),
                 far = l + OVERHANG;
    addQuad (scene, place (-far, out, drop), place (far, out, drop), place (far, 0.0, ridge),
             place (-far, 0.0, ridge), building);
  }
}

void
addTree (RayScene& scene, const Vector3d& foot, const TreeSize& size, Random& random)
{
  const double leaves_per_volume = 60.0, leaf_radius = 0.07;
  Vector3d half;
  for (const int axis : {2, 1, 0})
    half[axis] = random.uniform (size.smallest[axis], size.largest[axis]);
  const double trunk = random.uniform (2.0, 3.5);
  const Vector3d centre = foot + Vector3d (0.0, 0.0, trunk + half.z ());
  scene.addRod (foot, centre, random.uniform (0.15, 0.25), truth (2, LidarClass::VEGETATION));
  const double leaves = leaves_per_volume * 4.0 / 3.0 * pi<double> () * half.prod ();
  for (double leaf = 0.0; leaf < leaves; leaf += 1.0) {
    const double radius = std::cbrt (random.uniform ());
    const Vector3d where = centre + radius * random.direction ().cwiseProduct (half);
    scene.addDisc (where, random.direction (), leaf_radius, truth (3, LidarClass::VEGETATION));
  }
}

} // namespace generate
