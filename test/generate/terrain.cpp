#include <generate/curves.h>
#include <generate/open_surfaces.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>

namespace generate {

namespace {

using boost::math::constants::two_pi;

/** Height of rolling ground and its gradient. */
struct Waves
{
  double side, height;

  Eigen::Vector3d point (double x, double y) const
  {
    const double u = two_pi<double> () / side * x, v = two_pi<double> () / side * y;
    const double z = std::sin (1.5 * u + 0.3) * std::cos (1.2 * v) + 0.4 * std::sin (2.3 * u - 1.1 * v + 1.0);
    return {x, y, height * z};
  }

  Eigen::Vector2d gradient (double x, double y) const
  {
    const double u = two_pi<double> () / side * x, v = two_pi<double> () / side * y;
    const double cross = 0.4 * std::cos (2.3 * u - 1.1 * v + 1.0);
    const Eigen::Vector2d slope (1.5 * std::cos (1.5 * u + 0.3) * std::cos (1.2 * v) + 2.3 * cross,
                                 -1.2 * std::sin (1.5 * u + 0.3) * std::sin (1.2 * v) - 1.1 * cross);
    return height * two_pi<double> () / side * slope;
  }

  /** Largest possible norm of the gradient. */
  double steepest () const
  {
    return height * two_pi<double> () / side * std::hypot (1.5 + 2.3 * 0.4, 1.2 + 1.1 * 0.4);
  }
};

/** The four sides of a terrain, each a curve over a side of the square. */
Shape
terrainRim (const Waves& waves)
{
  const double half = 0.5 * waves.side;
  const auto place = [half] (std::size_t side, double t) -> Eigen::Vector2d {
    const double along = (2.0 * t - 1.0) * half;
    switch (side) {
      case 0:
        return {along, -half};
      case 1:
        return {half, along};
      case 2:
        return {-along, half};
      default:
        return {-half, -along};
    }
  };
  const auto position = [waves, place] (std::size_t side, double t) {
    const Eigen::Vector2d xy = place (side, t);
    return waves.point (xy.x (), xy.y ());
  };
  const auto velocity = [waves, place] (std::size_t side, double t) -> Eigen::Vector3d {
    const Eigen::Vector2d xy = place (side, t);
    const Eigen::Vector2d step = place (side, 1.0) - place (side, 0.0);
    return {step.x (), step.y (), waves.gradient (xy.x (), xy.y ()).dot (step)};
  };
  std::vector<Shape> sides;
  std::vector<Eigen::Vector3d> corners;
  for (std::size_t side = 0; side < 4; ++side) {
    sides.push_back (spaceCurve (
      "terrain side", false, [=] (double t) { return position (side, t); },
      [=] (double t) { return velocity (side, t); }));
    corners.push_back (position (side, 0.0));
  }
  Shape shape;
  shape.name = "terrain rim";
  shape.dimension = 1;
  shape.topology = {0, 0};
  for (const Shape& side : sides)
    shape.patches.push_back (side.patches.front ());
  shape.extent = [sides] (std::size_t side, const Eigen::Vector3d& low, const Eigen::Vector3d& size) {
    return sides[side].extent (0, low, size);
  };
  shape.point = [position] (std::size_t side, const Eigen::Vector3d& u) { return position (side, u[0]); };
  shape.density = [velocity] (std::size_t side, const Eigen::Vector3d& u) {
    return velocity (side, u[0]).norm ();
  };
  shape.nearest = [sides] (const Eigen::Vector3d& p) {
    Nearest best = sides.front ().nearest (p);
    for (const Shape& side : sides) {
      const Nearest found = side.nearest (p);
      if (found.distance < best.distance)
        best = found;
    }
    return best;
  };
  shape.strata = {isolatedPoints ("terrain corners", corners)};
  return shape;
}

} // namespace

Shape
terrain (double side, double height)
{
  const Waves waves{side, height};
  const double half = 0.5 * side, slope = std::hypot (1.0, waves.steepest ());
  Shape shape = parametric (
    "terrain", 2, {1, 1}, {side * slope, side * slope, 0.0}, side * side * slope,
    [=] (const Eigen::Vector3d& u) { return waves.point ((u[0] - 0.5) * side, (u[1] - 0.5) * side); },
    [=] (const Eigen::Vector3d& u) {
      const Eigen::Vector2d gradient = waves.gradient ((u[0] - 0.5) * side, (u[1] - 0.5) * side);
      return side * side * std::sqrt (1.0 + gradient.squaredNorm ());
    });
  shape.nearest = [=] (const Eigen::Vector3d& p) {
    // Gauss-Newton on the squared distance, kept inside of the square.
    Eigen::Vector2d xy (std::clamp (p.x (), -half, half), std::clamp (p.y (), -half, half));
    for (int i = 0; i < 50; ++i) {
      const Eigen::Vector3d off = p - waves.point (xy.x (), xy.y ());
      const Eigen::Vector2d gradient = waves.gradient (xy.x (), xy.y ());
      const Eigen::Matrix2d metric = Eigen::Matrix2d::Identity () + gradient * gradient.transpose ();
      const Eigen::Vector2d step = metric.inverse () * (off.head<2> () + off.z () * gradient);
      const Eigen::Vector2d next = (xy + step).cwiseMax (-half).cwiseMin (half);
      const double change = (next - xy).norm ();
      xy = next;
      if (change < 1e-14 * side)
        break;
    }
    const Eigen::Vector3d x = waves.point (xy.x (), xy.y ());
    const Eigen::Vector2d gradient = waves.gradient (xy.x (), xy.y ());
    const Eigen::Vector3d normal (-gradient.x (), -gradient.y (), 1.0);
    return Nearest{x, normal.normalized (), (x - p).norm ()};
  };
  shape.strata = {terrainRim (waves)};
  return shape;
}

} // namespace generate
