#include <generate/closed_surfaces.h>
#include <generate/curves.h>
#include <generate/open_surfaces.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace generate {

namespace {

using boost::math::constants::pi;
using boost::math::constants::two_pi;
constexpr double INF = std::numeric_limits<double>::infinity ();

Shape
circleAt (double radius, double height)
{
  return moved (circle (radius), Eigen::Vector3d (0.0, 0.0, height));
}

/** Polar coordinates in the plane: the unit vector towards p, and across. */
Eigen::Vector3d
radial (double angle)
{
  return {std::cos (angle), std::sin (angle), 0.0};
}

} // namespace

Shape
hemisphere (double radius)
{
  const Shape whole = sphere (radius);
  Shape shape = parametric (
    "hemisphere", 2, {1, 1}, {0.5 * pi<double> () * radius, two_pi<double> () * radius, 0.0},
    0.5 * whole.patches.front ().density_bound,
    [whole] (const Eigen::Vector3d& u) {
      return whole.point (0, {0.5 * u[0], u[1], 0.0});
    },
    [whole] (const Eigen::Vector3d& u) {
      return 0.5 * whole.density (0, {0.5 * u[0], u[1], 0.0});
    });
  shape.strata = {circle (radius)};
  shape.nearest = [whole, rim = shape.strata.front ()] (const Eigen::Vector3d& p) {
    if (p.z () >= 0.0)
      return whole.nearest (p);
    const Nearest found = rim.nearest (p);
    return Nearest{found.point, found.point.normalized (), found.distance};
  };
  shape.feature_size = radius;
  return shape;
}

Shape
annulus (double inner_radius, double outer_radius)
{
  const double width = outer_radius - inner_radius;
  const auto radius = [=] (double u) { return inner_radius + width * u; };
  Shape shape = parametric (
    "annulus", 2, {0, 2}, {width, two_pi<double> () * outer_radius, 0.0},
    two_pi<double> () * outer_radius * width,
    [=] (const Eigen::Vector3d& u) -> Eigen::Vector3d {
      return radius (u[0]) * radial (two_pi<double> () * u[1]);
    },
    [=] (const Eigen::Vector3d& u) { return two_pi<double> () * radius (u[0]) * width; });
  shape.nearest = [=] (const Eigen::Vector3d& p) {
    const double off = std::clamp (std::hypot (p.x (), p.y ()), inner_radius, outer_radius);
    const Eigen::Vector3d x = off * radial (std::atan2 (p.y (), p.x ()));
    return Nearest{x, Eigen::Vector3d::UnitZ (), (x - p).norm ()};
  };
  shape.strata = {circle (inner_radius), circle (outer_radius)};
  shape.feature_size = inner_radius;
  return shape;
}

Shape
flatSquare (double side)
{
  const double half = 0.5 * side;
  Shape shape = parametric (
    "square", 2, {1, 1}, {side, side, 0.0}, side * side,
    [=] (const Eigen::Vector3d& u) -> Eigen::Vector3d {
      return {(u[0] - 0.5) * side, (u[1] - 0.5) * side, 0.0};
    },
    [=] (const Eigen::Vector3d&) { return side * side; });
  shape.nearest = [=] (const Eigen::Vector3d& p) {
    const Eigen::Vector3d x (std::clamp (p.x (), -half, half), std::clamp (p.y (), -half, half), 0.0);
    return Nearest{x, Eigen::Vector3d::UnitZ (), (x - p).norm ()};
  };
  shape.strata = {closedPolygon (
    "square rim", {{-half, -half, 0.0}, {half, -half, 0.0}, {half, half, 0.0}, {-half, half, 0.0}})};
  shape.feature_size = INF;
  return shape;
}

Shape
openCylinder (double radius, double height)
{
  const double around = two_pi<double> () * radius;
  Shape shape = parametric (
    "cylinder", 2, {0, 2}, {around, height, 0.0}, around * height,
    [=] (const Eigen::Vector3d& u) -> Eigen::Vector3d {
      return radius * radial (two_pi<double> () * u[0]) + (u[1] - 0.5) * height * Eigen::Vector3d::UnitZ ();
    },
    [=] (const Eigen::Vector3d&) { return around * height; });
  shape.nearest = [=] (const Eigen::Vector3d& p) {
    const Eigen::Vector3d normal = radial (std::atan2 (p.y (), p.x ()));
    const double z = std::clamp (p.z (), -0.5 * height, 0.5 * height);
    const Eigen::Vector3d x = radius * normal + z * Eigen::Vector3d::UnitZ ();
    return Nearest{x, normal, (x - p).norm ()};
  };
  shape.strata = {circleAt (radius, -0.5 * height), circleAt (radius, 0.5 * height)};
  shape.feature_size = radius;
  return shape;
}

} // namespace generate
