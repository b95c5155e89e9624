#include <generate/ray_scene.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace generate {

namespace {

/** Does a ray meet a box between two distances? */
bool
meets (const Eigen::AlignedBox3d& box, const Ray& ray, const Eigen::Array3d& inverse, double from, double to)
{
  const Eigen::Array3d one = (box.min () - ray.origin).array () * inverse;
  const Eigen::Array3d other = (box.max () - ray.origin).array () * inverse;
  return std::max (from, one.min (other).maxCoeff ()) <= std::min (to, one.max (other).minCoeff ());
}

} // namespace

void
RayScene::addTriangle (const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                       Truth truth)
{
  Eigen::AlignedBox3d bounds (a);
  bounds.extend (b).extend (c);
  things_.push_back ({Triangle{a, b, c}, truth, false, bounds});
}

void
RayScene::addDisc (const Eigen::Vector3d& centre, const Eigen::Vector3d& normal, double radius, Truth truth)
{
  const Eigen::Vector3d half = Eigen::Vector3d::Constant (radius);
  things_.push_back ({Disc{centre, normal, radius}, truth, true, {centre - half, centre + half}});
}

void
RayScene::addRod (const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius, Truth truth)
{
  const Eigen::Vector3d half = Eigen::Vector3d::Constant (std::max (radius, beam_radius_));
  Eigen::AlignedBox3d bounds (from - half, from + half);
  bounds.extend (to - half).extend (to + half);
  const double length = (to - from).norm ();
  things_.push_back ({Rod{from, (to - from) / length, length, radius}, truth, radius < beam_radius_, bounds});
}

void
RayScene::setGround (std::function<double (double x, double y)> height, double steepest, Truth truth)
{
  ground_ = std::move (height);
  steepest_ = steepest;
  ground_truth_ = truth;
}

void
RayScene::build ()
{
  nodes_.clear ();
  if (!things_.empty ())
    buildNode (0, things_.size ());
}

void
RayScene::buildNode (std::size_t first, std::size_t last)
{
  constexpr std::size_t FEW = 4;
  const std::size_t node = nodes_.size ();
  nodes_.push_back ({{}, first, last - first});
  for (std::size_t i = first; i < last; ++i)
    nodes_[node].bounds.extend (things_[i].bounds);
  if (last - first <= FEW)
    return;
  int axis = 0;
  nodes_[node].bounds.sizes ().maxCoeff (&axis);
  const auto at = [this] (std::size_t i) { return things_.begin () + static_cast<std::ptrdiff_t> (i); };
  const std::size_t middle = first + (last - first) / 2;
  // The order within a half may differ between standard libraries; which thing is nearest does not.
  std::nth_element (at (first), at (middle), at (last), [axis] (const Thing& a, const Thing& b) {
    return a.bounds.center ()[axis] < b.bounds.center ()[axis];
  });
  buildNode (first, middle);
  nodes_[node].first = nodes_.size ();
  nodes_[node].count = 0;
  buildNode (middle, last);
}

std::optional<RayHit>
RayScene::cast (const Ray& ray, double from, double to) const
{
  std::optional<RayHit> best;
  if (ground_)
    if (const auto range = hitGround (ray, from, to)) {
      best = RayHit{*range, ground_truth_, false};
      to = *range;
    }
  const Eigen::Array3d inverse = ray.direction.array ().inverse ();
  std::vector<std::size_t> open;
  if (!nodes_.empty ())
    open.push_back (0);
  while (!open.empty ()) {
    const std::size_t index = open.back ();
    const Node& node = nodes_[index];
    open.pop_back ();
    if (!meets (node.bounds, ray, inverse, from, to))
      continue;
    if (node.count == 0) {
      open.push_back (node.first);
      open.push_back (index + 1);
      continue;
    }
    for (std::size_t i = node.first; i < node.first + node.count; ++i) {
      const Thing& thing = things_[i];
      const auto range = std::visit ([&] (const auto& form) { return hit (form, ray, from); }, thing.form);
      if (range && *range < to) {
        best = RayHit{*range, thing.truth, thing.partial};
        to = *range;
      }
    }
  }
  return best;
}

std::optional<double>
RayScene::hit (const Triangle& triangle, const Ray& ray, double from) const
{
  const Eigen::Vector3d ab = triangle.b - triangle.a, ac = triangle.c - triangle.a;
  const Eigen::Vector3d across = ray.direction.cross (ac);
  const double volume = ab.dot (across);
  if (volume == 0.0)
    return std::nullopt;
  const Eigen::Vector3d off = ray.origin - triangle.a;
  const double u = off.dot (across) / volume;
  const Eigen::Vector3d turned = off.cross (ab);
  const double v = ray.direction.dot (turned) / volume;
  const double range = ac.dot (turned) / volume;
  if (!(u >= 0.0 && v >= 0.0 && u + v <= 1.0 && range >= from))
    return std::nullopt;
  return range;
}

std::optional<double>
RayScene::hit (const Disc& disc, const Ray& ray, double from) const
{
  const double towards = disc.normal.dot (ray.direction);
  if (towards == 0.0)
    return std::nullopt;
  const double range = disc.normal.dot (disc.centre - ray.origin) / towards;
  const Eigen::Vector3d off = ray.origin + range * ray.direction - disc.centre;
  if (!(range >= from && off.squaredNorm () <= disc.radius * disc.radius))
    return std::nullopt;
  return range;
}

std::optional<double>
RayScene::hit (const Rod& rod, const Ray& ray, double from) const
{
  const Eigen::Vector3d off = ray.origin - rod.from;
  const double slant = ray.direction.dot (rod.axis);
  const double square = 1.0 - slant * slant; // of the speed across the axis
  if (square < 1e-12)
    return std::nullopt;
  const double nearest = (slant * off.dot (rod.axis) - ray.direction.dot (off)) / square;
  const auto alongRod = [&] (double range) { return (off + range * ray.direction).dot (rod.axis); };
  const Eigen::Vector3d apart = off + nearest * ray.direction - alongRod (nearest) * rod.axis;
  const double touch = std::max (rod.radius, beam_radius_);
  if (apart.squaredNorm () > touch * touch)
    return std::nullopt;
  // A thin rod answers from where the pulse passes it, a thick one from its surface.
  const double depth2 = rod.radius * rod.radius - apart.squaredNorm ();
  const bool thin = rod.radius < beam_radius_;
  const double range = thin || depth2 <= 0.0 ? nearest : nearest - std::sqrt (depth2 / square);
  const double along = alongRod (range);
  if (!(range >= from && along >= 0.0 && along <= rod.length))
    return std::nullopt;
  return range;
}

std::optional<double>
RayScene::hitGround (const Ray& ray, double from, double to) const
{
  // Each step is too short to pass through ground of the greatest slope.
  const double closing = -ray.direction.z () + steepest_ * ray.direction.head<2> ().norm ();
  if (closing <= 0.0)
    return std::nullopt;
  double range = from;
  for (int step = 0; step < 1000 && range < to; ++step) {
    const Eigen::Vector3d place = ray.origin + range * ray.direction;
    const double above = place.z () - ground_ (place.x (), place.y ());
    if (above < 1e-4)
      return range;
    range += above / closing;
  }
  return std::nullopt;
}

} // namespace generate
