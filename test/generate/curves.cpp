#include <generate/curves.h>

#include <boost/math/constants/constants.hpp>
#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace generate {

namespace {

using boost::math::constants::two_pi;
constexpr double INF = std::numeric_limits<double>::infinity ();

/** Upper bound of a smooth function over [0, 1]: the largest of many values, and a bit more. */
double
boundOver (const std::function<double (double)>& f)
{
  constexpr int COUNT = 2048;
  double largest = 0.0;
  for (int i = 0; i <= COUNT; ++i)
    largest = std::max (largest, f (static_cast<double> (i) / COUNT));
  return 1.001 * largest;
}

} // namespace

CurveSearch::CurveSearch (std::function<Eigen::Vector3d (double t)> position, std::size_t table_size)
  : position_ (std::move (position))
{
  for (std::size_t i = 0; i <= table_size; ++i)
    table_.push_back (position_ (static_cast<double> (i) / static_cast<double> (table_size)));
}

double
CurveSearch::operator() (const Eigen::Vector3d& p) const
{
  std::size_t best = 0;
  for (std::size_t i = 1; i < table_.size (); ++i)
    if ((table_[i] - p).squaredNorm () < (table_[best] - p).squaredNorm ())
      best = i;
  // Start and end of a closed curve are the same point: the search has to go on across it.
  const bool closed = (table_.front () - table_.back ()).norm () < 1e-9;
  const double step = 1.0 / static_cast<double> (table_.size () - 1);
  double low = (static_cast<double> (best) - 1.0) * step, high = low + 2.0 * step;
  if (!closed) {
    low = std::max (low, 0.0);
    high = std::min (high, 1.0);
  }
  const auto squared = [this, &p] (double t) { return (position_ (t) - p).squaredNorm (); };
  const auto found = boost::math::tools::brent_find_minima (squared, low, high, 40);
  double t = found.first;
  if (!closed)
    for (const double end : {0.0, 1.0})
      if (squared (end) <= squared (t))
        t = end;
  return t;
}

Shape
spaceCurve (const std::string& name, bool closed, const std::function<Eigen::Vector3d (double t)>& position,
            const std::function<Eigen::Vector3d (double t)>& velocity)
{
  const double bound = boundOver ([&] (double t) { return velocity (t).norm (); });
  Shape shape = parametric (
    name, 1, {closed ? 0 : 1, closed ? 0 : 2}, {bound, 0.0, 0.0}, bound,
    [position] (const Eigen::Vector3d& u) { return position (u[0]); },
    [velocity] (const Eigen::Vector3d& u) { return velocity (u[0]).norm (); });
  shape.nearest = [search = CurveSearch (position, 512), position, velocity] (const Eigen::Vector3d& p) {
    const double t = search (p);
    const Eigen::Vector3d x = position (t);
    return Nearest{x, velocity (t).normalized (), (x - p).norm ()};
  };
  if (!closed)
    shape.strata = {isolatedPoints (name + " ends", {position (0.0), position (1.0)})};
  return shape;
}

Shape
straightEdges (const std::string& name, const std::vector<Eigen::Vector3d>& corners,
               const std::vector<std::pair<std::size_t, std::size_t>>& edges)
{
  std::vector<Eigen::Vector3d> from, along;
  Shape shape;
  shape.name = name;
  shape.dimension = 1;
  shape.topology = {static_cast<int> (corners.size ()) - static_cast<int> (edges.size ()), 0};
  for (const auto& [first, last] : edges) {
    from.push_back (corners[first]);
    along.push_back (corners[last] - corners[first]);
    shape.patches.push_back ({along.back ().norm (), along.back ().norm ()});
  }
  shape.point = [from, along] (std::size_t i, const Eigen::Vector3d& u) -> Eigen::Vector3d {
    return from[i] + u[0] * along[i];
  };
  shape.density = [patches = shape.patches] (std::size_t i, const Eigen::Vector3d&) {
    return patches[i].measure;
  };
  shape.extent = [patches = shape.patches] (std::size_t i, const Eigen::Vector3d&,
                                            const Eigen::Vector3d& size) {
    return Eigen::Vector3d (patches[i].measure * size[0], 0.0, 0.0);
  };
  shape.nearest = [from, along] (const Eigen::Vector3d& p) {
    Nearest best{p, Eigen::Vector3d::UnitX (), INF};
    for (std::size_t i = 0; i < from.size (); ++i) {
      const double t = std::clamp ((p - from[i]).dot (along[i]) / along[i].squaredNorm (), 0.0, 1.0);
      const Eigen::Vector3d x = from[i] + t * along[i];
      if ((x - p).norm () < best.distance)
        best = {x, along[i].normalized (), (x - p).norm ()};
    }
    return best;
  };
  shape.strata = {isolatedPoints (name + " corners", corners)};
  return shape;
}

Shape
closedPolygon (const std::string& name, const std::vector<Eigen::Vector3d>& corners)
{
  std::vector<std::pair<std::size_t, std::size_t>> edges;
  for (std::size_t i = 0; i < corners.size (); ++i)
    edges.emplace_back (i, (i + 1) % corners.size ());
  return straightEdges (name, corners, edges);
}

Shape
circle (double radius)
{
  const double length = two_pi<double> () * radius;
  Shape shape = parametric (
    "circle", 1, {0, 0}, {length, 0.0, 0.0}, length,
    [radius] (const Eigen::Vector3d& u) -> Eigen::Vector3d {
      const double angle = two_pi<double> () * u[0];
      return {radius * std::cos (angle), radius * std::sin (angle), 0.0};
    },
    [length] (const Eigen::Vector3d&) { return length; });
  shape.nearest = [radius] (const Eigen::Vector3d& p) {
    const double angle = std::atan2 (p.y (), p.x ());
    const Eigen::Vector3d x (radius * std::cos (angle), radius * std::sin (angle), 0.0);
    return Nearest{x, {-std::sin (angle), std::cos (angle), 0.0}, (x - p).norm ()};
  };
  shape.feature_size = radius;
  return shape;
}

CurveFrame
trefoilFrame (double scale, double angle)
{
  const double s1 = std::sin (angle), c1 = std::cos (angle);
  const double s2 = std::sin (2.0 * angle), c2 = std::cos (2.0 * angle);
  const double s3 = std::sin (3.0 * angle), c3 = std::cos (3.0 * angle);
  return {scale * Eigen::Vector3d (s1 + 2.0 * s2, c1 - 2.0 * c2, -s3),
          scale * Eigen::Vector3d (c1 + 4.0 * c2, -s1 + 4.0 * s2, -3.0 * c3),
          scale * Eigen::Vector3d (-s1 - 8.0 * s2, -c1 + 8.0 * c2, 9.0 * s3)};
}

Shape
trefoil (double scale)
{
  Shape shape = spaceCurve (
    "trefoil", true, [scale] (double t) { return trefoilFrame (scale, two_pi<double> () * t).position; },
    [scale] (double t) -> Eigen::Vector3d {
      return two_pi<double> () * trefoilFrame (scale, two_pi<double> () * t).velocity;
    });
  shape.feature_size = 0.6 * scale;
  return shape;
}

Shape
helix (double radius, double pitch, double turns)
{
  const double sweep = two_pi<double> () * turns, rise = pitch * turns;
  return spaceCurve (
    "helix", false,
    [=] (double t) -> Eigen::Vector3d {
      return {radius * std::cos (sweep * t), radius * std::sin (sweep * t), rise * t};
    },
    [=] (double t) -> Eigen::Vector3d {
      return {-radius * sweep * std::sin (sweep * t), radius * sweep * std::cos (sweep * t), rise};
    });
}

Shape
segment (const Eigen::Vector3d& from, const Eigen::Vector3d& to)
{
  const Eigen::Vector3d side = to - from;
  Shape shape = spaceCurve (
    "segment", false, [=] (double t) -> Eigen::Vector3d { return from + t * side; },
    [=] (double) { return side; });
  shape.feature_size = INF;
  return shape;
}

} // namespace generate
