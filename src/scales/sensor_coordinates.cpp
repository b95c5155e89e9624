#include "scales/sensor_coordinates.h"

#include "common/parallel.h"
#include "scales/local_spread.h"
#include "scales/scale_ladder.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <vector>

namespace pcl {
namespace manifold {

namespace {

constexpr std::size_t ASKED = 3000;
// (sigma1 - sigma2) / sigma1 of a point and its neighbours on a line.
constexpr double LINEAR = 0.8;
// Of a line around the axis, its rise in a share of its run. Beams of real sensors rise by less.
constexpr double LEVEL = 0.2;
// Shares of points on lines, and of level ones of these: frames have 0.31 and 0.97 or more, other clouds
// either less than 0.05 of the first or less than 0.15 of the second.
constexpr double SHARE_ON_LINES = 0.15;
constexpr double SHARE_LEVEL = 0.7;
constexpr Eigen::Index FEWEST_POINTS = 1000;

} // namespace

SensorCoordinates::SensorCoordinates (const Eigen::Matrix3Xd& points, const Eigen::Vector3d& origin)
  : origin_ (origin)
{
  std::vector<double> ranges (static_cast<std::size_t> (points.cols ()));
  for (std::size_t i = 0; i < ranges.size (); ++i)
    ranges[i] = (points.col (static_cast<Eigen::Index> (i)) - origin).norm ();
  const auto middle = ranges.begin () + static_cast<std::ptrdiff_t> (ranges.size () / 2);
  std::nth_element (ranges.begin (), middle, ranges.end ());
  near_ = *middle / std::exp (1.0);
}

Eigen::Matrix3Xd
SensorCoordinates::toSensor (const Eigen::Matrix3Xd& points) const
{
  Eigen::Matrix3Xd seen (3, points.cols ());
  parallelFor (static_cast<std::size_t> (points.cols ()), [&] (std::size_t i) {
    const auto column = static_cast<Eigen::Index> (i);
    seen.col (column) = (points.col (column) - origin_) / widthAt (points.col (column));
  });
  return seen;
}

double
SensorCoordinates::widthAt (const Eigen::Vector3d& point) const
{
  if (!(near_ > 0.0))
    return 1.0;
  const double range = (point - origin_).norm ();
  return range > near_ ? range / (1.0 + std::log (range / near_)) : near_;
}

Eigen::Vector3d
SensorCoordinates::toSpace (const Eigen::Vector3d& point, const Eigen::Vector3d& direction) const
{
  const double range = (point - origin_).norm ();
  if (!(near_ > 0.0) || range <= near_)
    return direction;
  const Eigen::Vector3d ray = (point - origin_) / range;
  const double radial = direction.dot (ray);
  return (radial * range * ray + widthAt (point) * (direction - radial * ray)).normalized ();
}

bool
hasRings (const Eigen::Matrix3Xd& points, const std::vector<pcl::index_t>& neighbors,
          const Eigen::Vector3d& origin)
{
  if (points.cols () < FEWEST_POINTS)
    return false;
  const std::size_t step = std::max<std::size_t> (1, static_cast<std::size_t> (points.cols ()) / ASKED);
  std::size_t asked = 0, lines = 0, level = 0;
  for (Eigen::Index i = 0; i < points.cols (); i += static_cast<Eigen::Index> (step)) {
    const Eigen::Vector3d seen = points.col (i) - origin;
    const Eigen::Vector3d around = Eigen::Vector3d::UnitZ ().cross (seen);
    if (!(around.norm () > 0.0))
      continue;
    ++asked;
    LocalSpread spread;
    for (int k = 0; k < NEAREST; ++k)
      spread.add (points.col (neighbors[static_cast<std::size_t> (i) * NEAREST + k]) - points.col (i));
    spread.solve ();
    if (spread.linearity () <= LINEAR)
      continue;
    ++lines;
    const Eigen::Vector3d& direction = spread.direction ();
    const double rise = std::abs (direction.dot (seen.cross (around).normalized ()));
    if (rise < LEVEL * std::abs (direction.dot (around.normalized ())))
      ++level;
  }
  return static_cast<double> (lines) > SHARE_ON_LINES * static_cast<double> (asked) &&
         static_cast<double> (level) > SHARE_LEVEL * static_cast<double> (lines);
}

} // namespace manifold
} // namespace pcl
