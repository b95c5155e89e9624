#include <generate/closed_surfaces.h>
#include <generate/curves.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>

namespace generate {

namespace {

using boost::math::constants::pi;
using boost::math::constants::two_pi;

/** The point of the unit sphere for a point of the unit square: polar angle, azimuth. */
Eigen::Vector3d
onUnitSphere (const Eigen::Vector3d& u)
{
  const double polar = pi<double> () * u[0], azimuth = two_pi<double> () * u[1];
  return {std::sin (polar) * std::cos (azimuth), std::sin (polar) * std::sin (azimuth), std::cos (polar)};
}

/** How much area of the unit sphere a unit of the square makes. */
double
unitSphereDensity (const Eigen::Vector3d& u)
{
  return 2.0 * pi<double> () * pi<double> () * std::sin (pi<double> () * u[0]);
}

/** How large a box of the square becomes on the unit sphere: as wide as at its polar angle nearest to the
 * equator. */
Eigen::Vector3d
unitSphereExtent (const Eigen::Vector3d& low, const Eigen::Vector3d& size)
{
  const double widest = std::clamp (0.5, low[0], low[0] + size[0]);
  return {pi<double> () * size[0], two_pi<double> () * std::sin (pi<double> () * widest) * size[1], 0.0};
}

/** The point of an ellipsoid that is nearest to p: x_i = a_i^2 p_i / (a_i^2 + t) with the largest t that puts
 * it on the ellipsoid, found by bisection. For a place on the medial axis one of the nearest points is taken,
 * by moving its zero coordinates off zero. */
Eigen::Vector3d
nearestOnEllipsoid (const Eigen::Vector3d& axes, const Eigen::Vector3d& p)
{
  const double smallest = axes.minCoeff ();
  const Eigen::Array3d q = p.cwiseAbs ().cwiseMax (1e-12 * smallest);
  const Eigen::Array3d scaled = axes.array () * q;
  // By s = t + smallest^2, so that nothing is cancelled where the solution is next to the smallest s, 0.
  const Eigen::Array3d beyond = axes.array ().square () - smallest * smallest;
  const auto excess = [&] (double s) { return (scaled / (beyond + s)).square ().sum () - 1.0; };
  double low = 0.0, high = smallest * smallest + scaled.matrix ().norm ();
  while (true) {
    const double middle = 0.5 * (low + high);
    if (middle <= low || middle >= high)
      break;
    (excess (middle) > 0.0 ? low : high) = middle;
  }
  Eigen::Vector3d x = axes.array () * scaled / (beyond + high);
  for (int axis = 0; axis < 3; ++axis)
    x[axis] = std::copysign (x[axis], p[axis]);
  return x;
}

} // namespace

Shape
sphere (double radius)
{
  Shape shape = parametric (
    "sphere", 2, {2, 0}, Eigen::Vector3d::Zero (), 2.0 * std::pow (pi<double> () * radius, 2),
    [radius] (const Eigen::Vector3d& u) -> Eigen::Vector3d { return radius * onUnitSphere (u); },
    [radius] (const Eigen::Vector3d& u) { return radius * radius * unitSphereDensity (u); });
  shape.extent = [radius] (std::size_t, const Eigen::Vector3d& low,
                           const Eigen::Vector3d& size) -> Eigen::Vector3d {
    return radius * unitSphereExtent (low, size);
  };
  shape.nearest = [radius] (const Eigen::Vector3d& p) {
    const double norm = p.norm ();
    const Eigen::Vector3d normal = norm > 0.0 ? Eigen::Vector3d (p / norm) : Eigen::Vector3d::UnitZ ();
    return Nearest{radius * normal, normal, std::abs (norm - radius)};
  };
  shape.feature_size = radius;
  return shape;
}

Shape
ellipsoid (const Eigen::Vector3d& half_axes)
{
  const double largest = half_axes.maxCoeff (), smallest = half_axes.minCoeff ();
  // What the affine map from the unit sphere does to its area elements, by their normal.
  const Eigen::Vector3d cofactors = half_axes.prod () * half_axes.cwiseInverse ();
  Shape shape = parametric (
    "ellipsoid", 2, {2, 0}, Eigen::Vector3d::Zero (),
    2.0 * pi<double> () * pi<double> () * cofactors.maxCoeff (),
    [half_axes] (const Eigen::Vector3d& u) -> Eigen::Vector3d {
      return half_axes.cwiseProduct (onUnitSphere (u));
    },
    [cofactors] (const Eigen::Vector3d& u) {
      return unitSphereDensity (u) * cofactors.cwiseProduct (onUnitSphere (u)).norm ();
    });
  shape.extent = [largest] (std::size_t, const Eigen::Vector3d& low,
                            const Eigen::Vector3d& size) -> Eigen::Vector3d {
    return largest * unitSphereExtent (low, size);
  };
  shape.nearest = [half_axes] (const Eigen::Vector3d& p) {
    const Eigen::Vector3d x = nearestOnEllipsoid (half_axes, p);
    const Eigen::Vector3d normal = (x.array () / half_axes.array ().square ()).matrix ().normalized ();
    return Nearest{x, normal, (x - p).norm ()};
  };
  // The smallest radius of curvature; an ellipsoid has no narrower place.
  shape.feature_size = smallest * smallest / largest;
  return shape;
}

double
ellipsoidFeatureSize (const Eigen::Vector3d& half_axes, const Eigen::Vector3d& place)
{
  int shortest = 0;
  const double smallest = half_axes.minCoeff (&shortest);
  // The disk lies across the shortest axis; its rim is where the sharpest bends have their centres.
  const double a = half_axes[(shortest + 1) % 3], b = half_axes[(shortest + 2) % 3];
  const Eigen::Array2d disk ((a * a - smallest * smallest) / a, (b * b - smallest * smallest) / b);
  const Eigen::Array2d p (std::abs (place[(shortest + 1) % 3]), std::abs (place[(shortest + 2) % 3]));
  // The nearest place of the disk is disk^2 p / (disk^2 + t) with the smallest t that puts it there.
  const auto nearest = [&] (double t) -> Eigen::Array2d { return disk.square () * p / (disk.square () + t); };
  const auto outside = [&] (double t) { return (disk * p / (disk.square () + t)).square ().sum () > 1.0; };
  Eigen::Array2d at = p;
  if (outside (0.0)) {
    double low = 0.0, high = (disk * p).matrix ().norm ();
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (low + high);
      (outside (middle) ? low : high) = middle;
    }
    at = nearest (high);
  }
  return std::hypot ((p - at).matrix ().norm (), place[shortest]);
}

Shape
torus (double big_radius, double small_radius)
{
  const double full = two_pi<double> () * two_pi<double> () * small_radius;
  Shape shape = parametric (
    "torus", 2, {0, 0},
    {two_pi<double> () * small_radius, two_pi<double> () * (big_radius + small_radius), 0.0},
    full * (big_radius + small_radius),
    [=] (const Eigen::Vector3d& u) -> Eigen::Vector3d {
      const double tube = two_pi<double> () * u[0], axis = two_pi<double> () * u[1];
      const double ring = big_radius + small_radius * std::cos (tube);
      return {ring * std::cos (axis), ring * std::sin (axis), small_radius * std::sin (tube)};
    },
    [=] (const Eigen::Vector3d& u) {
      return full * (big_radius + small_radius * std::cos (two_pi<double> () * u[0]));
    });
  shape.nearest = [=] (const Eigen::Vector3d& p) {
    const double axis = std::atan2 (p.y (), p.x ());
    const Eigen::Vector3d centre (big_radius * std::cos (axis), big_radius * std::sin (axis), 0.0);
    const double off = (p - centre).norm ();
    const Eigen::Vector3d normal =
      off > 0.0 ? Eigen::Vector3d ((p - centre) / off) : Eigen::Vector3d::UnitZ ();
    return Nearest{centre + small_radius * normal, normal, std::abs (off - small_radius)};
  };
  shape.feature_size = std::min (small_radius, big_radius - small_radius);
  return shape;
}

double
torusFeatureSize (double small_radius, const Eigen::Vector3d& place)
{
  return std::min (small_radius, std::hypot (place.x (), place.y ()));
}

Shape
knottedTube (double scale, double radius)
{
  // The trefoil's velocity never becomes parallel to the z axis, so this frame never breaks down.
  const auto offset = [] (const CurveFrame& frame, double tube) -> Eigen::Vector3d {
    const Eigen::Vector3d side = frame.velocity.cross (Eigen::Vector3d::UnitZ ()).normalized ();
    const Eigen::Vector3d up = side.cross (frame.velocity).normalized ();
    return std::cos (tube) * side + std::sin (tube) * up;
  };
  const auto point = [=] (const Eigen::Vector3d& u) -> Eigen::Vector3d {
    const CurveFrame frame = trefoilFrame (scale, two_pi<double> () * u[0]);
    return frame.position + radius * offset (frame, two_pi<double> () * u[1]);
  };
  const auto density = [=] (const Eigen::Vector3d& u) {
    const CurveFrame frame = trefoilFrame (scale, two_pi<double> () * u[0]);
    const double speed = frame.velocity.norm ();
    const double bend = frame.acceleration.dot (offset (frame, two_pi<double> () * u[1]));
    return two_pi<double> () * two_pi<double> () * radius * (speed - radius * bend / speed);
  };
  // Bounds by looking at many places: the map is smooth, so a bit more than the largest value holds
  // everywhere.
  constexpr int COUNT = 256;
  double along = 0.0, bound = 0.0;
  for (int i = 0; i < COUNT; ++i)
    for (int j = 0; j < COUNT; ++j) {
      const Eigen::Vector3d here (static_cast<double> (i) / COUNT, static_cast<double> (j) / COUNT, 0.0);
      const Eigen::Vector3d next = here + Eigen::Vector3d (1.0 / COUNT, 0.0, 0.0);
      along = std::max (along, COUNT * (point (next) - point (here)).norm ());
      bound = std::max (bound, density (here));
    }
  // The frame twists, so the two directions are not orthogonal: the root of two makes up for that.
  const Eigen::Vector3d stretch =
    std::sqrt (2.0) * Eigen::Vector3d (1.1 * along, two_pi<double> () * radius, 0.0);
  Shape shape = parametric ("knotted-tube", 2, {0, 0}, stretch, 1.1 * bound, point, density);
  const auto axis = [scale] (double t) { return trefoilFrame (scale, two_pi<double> () * t).position; };
  shape.nearest = [search = CurveSearch (axis, 512), axis, radius] (const Eigen::Vector3d& p) {
    const Eigen::Vector3d centre = axis (search (p));
    const double off = (p - centre).norm ();
    const Eigen::Vector3d normal =
      off > 0.0 ? Eigen::Vector3d ((p - centre) / off) : Eigen::Vector3d::UnitZ ();
    return Nearest{centre + radius * normal, normal, std::abs (off - radius)};
  };
  // Beside the tube the knot has its own feature size left, less the radius on either side of it.
  shape.feature_size = std::min (radius, 0.6 * scale - radius);
  return shape;
}

} // namespace generate
