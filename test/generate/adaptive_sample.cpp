#include <generate/point_grid.h>
#include <generate/random.h>
#include <generate/sampling.h>

#include <algorithm>
#include <stdexcept>
#include <utility>
#include <vector>

namespace generate {

namespace {

/** A box of a patch's unit cube. */
struct Box
{
  std::size_t patch;
  Eigen::Vector3d low, size;
};

/** Cuts the shape into boxes, and these further until each has a point within the distance that is allowed
 * for all of its places. */
class AdaptiveCover
{
public:
  AdaptiveCover (const Shape& shape, const FeatureSize& feature_size, double eps, Random& random)
    : shape_ (shape), feature_size_ (feature_size), eps_ (eps), random_ (random)
  {}

  std::vector<Eigen::Vector3d> run ()
  {
    for (std::size_t patch = 0; patch < shape_.patches.size (); ++patch)
      cutUp ({patch, Eigen::Vector3d::Zero (), Eigen::Vector3d::Ones ()});
    for (std::size_t i = boxes_.size (); i > 1; --i)
      std::swap (boxes_[i - 1], boxes_[random_.index (i)]);
    PointGrid grid (largest_);
    for (const Box& box : boxes_)
      fill (box, grid);
    return std::move (points_);
  }

private:
  Eigen::Vector3d extent (const Box& box) const { return shape_.extent (box.patch, box.low, box.size); }

  Eigen::Vector3d anyPlace (const Box& box)
  {
    return shape_.point (box.patch, box.low + box.size.cwiseProduct (random_.cube ()));
  }

  /** The two halves of a box, cut where it is longest. */
  std::pair<Box, Box> halves (const Box& box) const
  {
    int axis = 0;
    extent (box).maxCoeff (&axis);
    Box first = box;
    first.size[axis] *= 0.5;
    Box second = first;
    second.low[axis] += first.size[axis];
    return {first, second};
  }

  void cutUp (const Box& box)
  {
    const double allowed = eps_ * feature_size_ (anyPlace (box));
    if (extent (box).norm () <= LARGEST_BOX * allowed) {
      largest_ = std::max (largest_, allowed);
      boxes_.push_back (box);
      return;
    }
    const auto [first, second] = halves (box);
    cutUp (first);
    cutUp (second);
  }

  void fill (const Box& box, PointGrid& grid)
  {
    const Eigen::Vector3d place = anyPlace (box);
    const double allowed = eps_ * feature_size_ (place);
    const double diameter = extent (box).norm ();
    // The feature size of another place of the box is smaller by the diameter at most.
    const double reach = allowed - (1.0 + eps_) * diameter;
    if (grid.anyWithin (place, reach))
      return;
    // No box is so large that a point of its own is not near enough to all of it.
    if (diameter < SMALLEST_BOX * allowed || !grid.anyWithin (place, allowed)) {
      grid.insert (place);
      points_.push_back (place);
      return;
    }
    const auto [first, second] = halves (box);
    fill (first, grid);
    fill (second, grid);
  }

  static constexpr double LARGEST_BOX = 0.5; ///< diameters, in distances that are allowed there
  static constexpr double SMALLEST_BOX = 0.02;

  const Shape& shape_;
  const FeatureSize& feature_size_;
  const double eps_;
  Random& random_;
  double largest_ = 0.0;
  std::vector<Box> boxes_;
  std::vector<Eigen::Vector3d> points_;
};

} // namespace

LabelledCloud
adaptiveSample (const Shape& shape, const FeatureSize& feature_size, double eps, std::uint64_t seed)
{
  if (!(eps > 0.0 && eps < 1.0))
    throw std::invalid_argument ("eps must be between 0 and 1");
  Random random (seed);
  LabelledCloud cloud;
  for (const Eigen::Vector3d& point : AdaptiveCover (shape, feature_size, eps, random).run ())
    cloud.add (point, static_cast<std::uint32_t> (shape.dimension));
  return cloud;
}

} // namespace generate
