#include <generate/blue_noise.h>
#include <generate/sampling.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

namespace generate {

namespace {

/** Powers of one half. */
const std::array<double, 256> POWERS = [] {
  std::array<double, 256> powers{};
  for (std::size_t i = 0; i < powers.size (); ++i)
    powers[i] = std::ldexp (1.0, -static_cast<int> (i));
  return powers;
}();

/** A box of a patch's unit cube. Its size is 2^-level along each axis. */
struct Box
{
  std::uint32_t patch;
  std::array<std::uint8_t, 3> level;
  Eigen::Vector3d low;
};

/** Covers a shape in two steps: random darts give the bulk of the points; then the shape is cut into boxes,
 * and each box is cut further until it is inside of the ball about a single point, with a random point tried
 * in each box that is not. */
class Cover
{
public:
  Cover (const Shape& shape, double spacing, PointGrid& grid, Random& random, const Tick& tick)
    : shape_ (shape), spacing_ (spacing), grid_ (grid), random_ (random), tick_ (tick)
  {}

  std::vector<Eigen::Vector3d> run ()
  {
    throwDarts ();
    std::vector<Box> boxes;
    for (std::size_t patch = 0; patch < shape_.patches.size (); ++patch)
      cutUp ({static_cast<std::uint32_t> (patch), {0, 0, 0}, Eigen::Vector3d::Zero ()}, boxes);
    for (std::size_t i = boxes.size (); i > 1; --i)
      std::swap (boxes[i - 1], boxes[random_.index (i)]);
    for (std::size_t i = 0; i < boxes.size (); ++i) {
      const Box& box = boxes[i];
      report (0.5, i, boxes.size ());
      near_.resize (1);
      const Eigen::Vector3d middle = centre (box);
      grid_.collectWithin (middle, spacing_ + radius (box), near_[0]);
      fill (box, middle, 0);
    }
    return std::move (points_);
  }

private:
  void throwDarts ()
  {
    const UniformDraw draw (shape_);
    const double wanted = shape_.dimension == 0 ? 0.0 : DARTS * expectedCount (shape_, spacing_);
    const auto darts = static_cast<std::size_t> (wanted);
    for (std::size_t dart = 0; dart < darts; ++dart) {
      report (0.0, dart, darts);
      const Eigen::Vector3d point = draw (random_);
      if (!grid_.anyWithin (point, spacing_))
        add (point);
    }
  }

  /** Tells how far one half of the work is. */
  void report (double before, std::size_t done, std::size_t all) const
  {
    if (tick_ && done % 4096 == 0)
      tick_ (before + 0.5 * static_cast<double> (done) / static_cast<double> (all));
  }

  void add (const Eigen::Vector3d& point)
  {
    grid_.insert (point);
    points_.push_back (point);
  }

  Eigen::Vector3d size (const Box& box) const
  {
    return {POWERS[box.level[0]], POWERS[box.level[1]], POWERS[box.level[2]]};
  }

  Eigen::Vector3d extent (const Box& box) const { return shape_.extent (box.patch, box.low, size (box)); }

  Eigen::Vector3d centre (const Box& box) const
  {
    return shape_.point (box.patch, box.low + 0.5 * size (box));
  }

  /** No point of the box is further than this from its centre. */
  double radius (const Box& box) const { return 0.5 * extent (box).norm (); }

  /** The two halves of a box, cut where it is longest. */
  std::array<Box, 2> halves (const Box& box) const
  {
    int axis = 0;
    extent (box).maxCoeff (&axis);
    Box first = box;
    ++first.level[static_cast<std::size_t> (axis)];
    Box second = first;
    second.low[axis] += size (first)[axis];
    return {first, second};
  }

  void cutUp (const Box& box, std::vector<Box>& boxes) const
  {
    if (radius (box) <= LARGEST_BOX * spacing_) {
      boxes.push_back (box);
      return;
    }
    for (const Box& half : halves (box))
      cutUp (half, boxes);
  }

  /** Covers a box. All points that could cover a place of it, or forbid one there, are in near_[depth];
   * points that are found are added to it and to the lists of the boxes around. */
  void fill (const Box& box, const Eigen::Vector3d& middle, std::size_t depth)
  {
    const double r = radius (box);
    if (isNear (middle, spacing_ - r, depth))
      return;
    if (r < 0.5 * SLACK * spacing_) {
      // As good as a single place: either a point is within the spacing or it becomes one.
      tryPoint (middle, depth);
      return;
    }
    tryPoint (shape_.point (box.patch, box.low + size (box).cwiseProduct (random_.cube ())), depth);

    if (near_.size () < depth + 2)
      near_.resize (depth + 2);
    for (const Box& half : halves (box)) {
      const double reach = spacing_ + radius (half);
      const Eigen::Vector3d half_middle = centre (half);
      near_[depth + 1].clear ();
      for (const Eigen::Vector3d& point : near_[depth])
        if ((point - half_middle).squaredNorm () < reach * reach)
          near_[depth + 1].push_back (point);
      fill (half, half_middle, depth + 1);
    }
  }

  bool isNear (const Eigen::Vector3d& place, double distance, std::size_t depth) const
  {
    if (distance <= 0.0)
      return false;
    for (const Eigen::Vector3d& point : near_[depth])
      if ((point - place).squaredNorm () < distance * distance)
        return true;
    return false;
  }

  void tryPoint (const Eigen::Vector3d& point, std::size_t depth)
  {
    if (isNear (point, spacing_, depth))
      return;
    add (point);
    for (std::size_t i = 0; i <= depth; ++i)
      near_[i].push_back (point);
  }

  static constexpr double DARTS = 8.0;       ///< for each point expected in the end
  static constexpr double LARGEST_BOX = 1.0; ///< radius of the boxes to begin with, in spacings
  static constexpr double SLACK = 0.001;     ///< of the spacing: no place is further away than that and it

  const Shape& shape_;
  const double spacing_;
  PointGrid& grid_;
  Random& random_;
  const Tick& tick_;
  std::vector<Eigen::Vector3d> points_;
  std::vector<std::vector<Eigen::Vector3d>> near_; ///< by the depth of a box
};

} // namespace

std::vector<Eigen::Vector3d>
coverShape (const Shape& shape, double spacing, PointGrid& grid, Random& random, const Tick& tick)
{
  return Cover (shape, spacing, grid, random, tick).run ();
}

} // namespace generate
