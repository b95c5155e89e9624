#include <generate/closed_surfaces.h>
#include <generate/curves.h>
#include <generate/solids.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace generate {

namespace {

using boost::math::constants::pi;
using boost::math::constants::two_pi;

/** The nearest point of a solid, given its skin and a test for its inside. */
std::function<Nearest (const Eigen::Vector3d&)>
nearestOfSolid (const Shape& skin, std::function<bool (const Eigen::Vector3d&)> inside)
{
  return [nearest = skin.nearest, inside = std::move (inside)] (const Eigen::Vector3d& p) {
    Nearest found = nearest (p);
    if (inside (p))
      found = {p, found.normal, 0.0};
    return found;
  };
}

Eigen::Vector3d
onTorus (double big_radius, double small_radius, double tube_angle, double axis_angle)
{
  const double ring = big_radius + small_radius * std::cos (tube_angle);
  return {ring * std::cos (axis_angle), ring * std::sin (axis_angle), small_radius * std::sin (tube_angle)};
}

/** The twelve edges of a box, with its corners as stratum. */
Shape
boxEdges (const Eigen::Vector3d& half)
{
  std::vector<Eigen::Vector3d> corners;
  std::vector<std::pair<std::size_t, std::size_t>> edges;
  for (std::size_t corner = 0; corner < 8; ++corner) {
    corners.emplace_back (corner & 1 ? half.x () : -half.x (), corner & 2 ? half.y () : -half.y (),
                          corner & 4 ? half.z () : -half.z ());
    for (const std::size_t axis : {1, 2, 4})
      if (!(corner & axis))
        edges.emplace_back (corner, corner | axis);
  }
  return straightEdges ("box edges", corners, edges);
}

Shape
boxSkin (const Eigen::Vector3d& half)
{
  Shape shape;
  shape.name = "box skin";
  shape.dimension = 2;
  shape.topology = {2, 0, true};
  for (int face = 0; face < 6; ++face) {
    const double area = 4.0 * half[(face / 2 + 1) % 3] * half[(face / 2 + 2) % 3];
    shape.patches.push_back ({area, area});
  }
  shape.point = [half] (std::size_t face, const Eigen::Vector3d& u) {
    const int axis = static_cast<int> (face) / 2, second = (axis + 1) % 3, third = (axis + 2) % 3;
    Eigen::Vector3d x;
    x[axis] = face % 2 == 0 ? -half[axis] : half[axis];
    x[second] = (2.0 * u[0] - 1.0) * half[second];
    x[third] = (2.0 * u[1] - 1.0) * half[third];
    return x;
  };
  shape.density = [patches = shape.patches] (std::size_t face, const Eigen::Vector3d&) {
    return patches[face].measure;
  };
  shape.extent = [half] (std::size_t face, const Eigen::Vector3d&, const Eigen::Vector3d& size) {
    const int axis = static_cast<int> (face) / 2;
    return Eigen::Vector3d (2.0 * half[(axis + 1) % 3] * size[0], 2.0 * half[(axis + 2) % 3] * size[1], 0.0);
  };
  shape.nearest = [half] (const Eigen::Vector3d& p) {
    Eigen::Vector3d x = p.cwiseMax (-half).cwiseMin (half);
    // The face that is nearest from inside; from outside the one that the point is beyond the most.
    int axis = 0;
    (half - p.cwiseAbs ()).minCoeff (&axis);
    const double side = p[axis] < 0.0 ? -1.0 : 1.0;
    x[axis] = side * half[axis];
    return Nearest{x, side * Eigen::Vector3d::Unit (axis), (x - p).norm ()};
  };
  shape.strata = {boxEdges (half)};
  return shape;
}

} // namespace

Shape
ball (double radius)
{
  Shape shape = parametric (
    "ball", 3, {1, 1}, Eigen::Vector3d::Zero (), 2.0 * pi<double> () * pi<double> () * std::pow (radius, 3),
    [radius] (const Eigen::Vector3d& u) -> Eigen::Vector3d {
      const double polar = pi<double> () * u[1], azimuth = two_pi<double> () * u[2], r = radius * u[0];
      return {r * std::sin (polar) * std::cos (azimuth), r * std::sin (polar) * std::sin (azimuth),
              r * std::cos (polar)};
    },
    [radius] (const Eigen::Vector3d& u) {
      return 2.0 * pi<double> () * pi<double> () * std::pow (radius, 3) * u[0] * u[0] *
             std::sin (pi<double> () * u[1]);
    });
  shape.extent = [skin = sphere (radius).extent, radius] (std::size_t, const Eigen::Vector3d& low,
                                                          const Eigen::Vector3d& size) -> Eigen::Vector3d {
    const Eigen::Vector3d on_skin = skin (0, low.tail<2> ().homogeneous (), size.tail<2> ().homogeneous ());
    const double outer = low[0] + size[0];
    return {radius * size[0], outer * on_skin[0], outer * on_skin[1]};
  };
  shape.strata = {sphere (radius)};
  shape.feature_size = radius;
  shape.nearest = nearestOfSolid (shape.strata.front (),
                                  [radius] (const Eigen::Vector3d& p) { return p.norm () <= radius; });
  return shape;
}

Shape
box (const Eigen::Vector3d& size)
{
  const Eigen::Vector3d half = 0.5 * size;
  const double volume = size.prod ();
  Shape shape = parametric (
    "box", 3, {1, 1}, size, volume,
    [size, half] (const Eigen::Vector3d& u) -> Eigen::Vector3d { return u.cwiseProduct (size) - half; },
    [volume] (const Eigen::Vector3d&) { return volume; });
  shape.strata = {boxSkin (half)};
  shape.nearest = nearestOfSolid (shape.strata.front (), [half] (const Eigen::Vector3d& p) {
    return (p.cwiseAbs ().array () <= half.array ()).all ();
  });
  return shape;
}

Shape
solidTorus (double big_radius, double small_radius)
{
  const double full = two_pi<double> () * two_pi<double> () * small_radius * small_radius;
  Shape shape = parametric (
    "solid-torus", 3, {0, 1}, Eigen::Vector3d::Zero (), full * (big_radius + small_radius),
    [=] (const Eigen::Vector3d& u) {
      return onTorus (big_radius, small_radius * u[0], two_pi<double> () * u[1], two_pi<double> () * u[2]);
    },
    [=] (const Eigen::Vector3d& u) {
      return full * u[0] * (big_radius + small_radius * u[0] * std::cos (two_pi<double> () * u[1]));
    });
  shape.extent = [=] (std::size_t, const Eigen::Vector3d& low,
                      const Eigen::Vector3d& size) -> Eigen::Vector3d {
    const double outer = small_radius * (low[0] + size[0]);
    return {small_radius * size[0], two_pi<double> () * outer * size[1],
            two_pi<double> () * (big_radius + outer) * size[2]};
  };
  shape.strata = {torus (big_radius, small_radius)};
  shape.feature_size = std::min (small_radius, big_radius - small_radius);
  shape.nearest = nearestOfSolid (shape.strata.front (), [=] (const Eigen::Vector3d& p) {
    return std::hypot (std::hypot (p.x (), p.y ()) - big_radius, p.z ()) <= small_radius;
  });
  return shape;
}

} // namespace generate
