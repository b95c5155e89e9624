#include <generate/curves.h>
#include <generate/open_surfaces.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>

namespace generate {

namespace {

using boost::math::constants::pi;
using boost::math::constants::two_pi;

/** The band consists of straight segments, one for each angle about the z axis. */
struct Band
{
  double radius, half_width;

  /** Unit vector from the axis towards the core of the band. */
  static Eigen::Vector3d radial (double angle) { return {std::cos (angle), std::sin (angle), 0.0}; }

  /** Unit vector along the segment. */
  static Eigen::Vector3d across (double angle)
  {
    return std::cos (0.5 * angle) * radial (angle) + std::sin (0.5 * angle) * Eigen::Vector3d::UnitZ ();
  }

  /** \param[in] off signed distance from the core along the segment */
  Eigen::Vector3d point (double angle, double off) const
  {
    return radius * radial (angle) + off * across (angle);
  }

  /** Derivative of the point by the angle; orthogonal to the segment. */
  Eigen::Vector3d velocity (double angle, double off) const
  {
    const Eigen::Vector3d turn =
      0.5 * (std::cos (0.5 * angle) * Eigen::Vector3d::UnitZ () - std::sin (0.5 * angle) * radial (angle));
    return off * turn + (radius + off * std::cos (0.5 * angle)) * radial (angle + 0.5 * pi<double> ());
  }

  /** Where the segment of an angle is nearest to p, as its distance from the core. */
  double nearestOff (double angle, const Eigen::Vector3d& p) const
  {
    return std::clamp ((p - radius * radial (angle)).dot (across (angle)), -half_width, half_width);
  }
};

} // namespace

Shape
moebiusBand (double radius, double half_width)
{
  const Band band{radius, half_width};
  const double full = two_pi<double> ();
  const double fastest = full * std::hypot (radius + half_width, 0.5 * half_width);
  const auto off = [half_width] (double u) { return (2.0 * u - 1.0) * half_width; };
  Shape shape = parametric (
    "moebius", 2, {0, 1, false}, {fastest, 2.0 * half_width, 0.0}, 2.0 * half_width * fastest,
    [=] (const Eigen::Vector3d& u) { return band.point (full * u[0], off (u[1])); },
    [=] (const Eigen::Vector3d& u) {
      return 2.0 * half_width * full * band.velocity (full * u[0], off (u[1])).norm ();
    });
  shape.nearest = [=] (const Eigen::Vector3d& p) {
    const auto foot = [&] (double t) { return band.point (full * t, band.nearestOff (full * t, p)); };
    const double angle = full * CurveSearch (foot, 128) (p);
    const double at = band.nearestOff (angle, p);
    const Eigen::Vector3d x = band.point (angle, at);
    const Eigen::Vector3d normal = band.velocity (angle, at).cross (Band::across (angle)).normalized ();
    return Nearest{x, normal, (x - p).norm ()};
  };
  // The rim goes around twice before it closes.
  shape.strata = {spaceCurve (
    "moebius rim", true, [=] (double t) { return band.point (2.0 * full * t, half_width); },
    [=] (double t) -> Eigen::Vector3d { return 2.0 * full * band.velocity (2.0 * full * t, half_width); })};
  return shape;
}

} // namespace generate
