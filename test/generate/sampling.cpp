#include <generate/blue_noise.h>
#include <generate/point_grid.h>
#include <generate/random.h>
#include <generate/sampling.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace generate {

namespace {

/** Points that a maximal Poisson-disk sample of spacing 1 has on a unit of length, area or volume: the
 * saturated densities of random sequential packing (Renyi's 0.7476, 0.547 and 0.384), made numbers of points.
 */
constexpr double POINTS_PER_UNIT[] = {1.0, 0.7476, 0.6966, 0.7335};

/** Adds points of a shape, or of a stratum of it, to the cloud of that shape. */
void
addPoints (const Shape& whole, const std::vector<Eigen::Vector3d>& points, bool is_stratum,
           LabelledCloud& cloud)
{
  // The creases of a closed surface are strata too, but no boundary.
  const bool on_boundary = is_stratum && whole.topology.boundary_components > 0;
  for (const Eigen::Vector3d& point : points)
    cloud.add (point, static_cast<std::uint32_t> (whole.dimension), is_stratum ? 0.0 : whole.depth (point),
               on_boundary);
}

/** A shape and, if wanted, its strata and theirs: corners before rims before the shape itself. */
void
listParts (const Shape& shape, Strata strata, std::vector<const Shape*>& parts)
{
  if (strata == Strata::SAMPLED)
    for (const Shape& stratum : shape.strata)
      listParts (stratum, strata, parts);
  parts.push_back (&shape);
}

std::vector<const Shape*>
partsOf (const Shape& shape, Strata strata)
{
  std::vector<const Shape*> parts;
  listParts (shape, strata, parts);
  return parts;
}

/** Finds the x at which a growing function of it has a value, between 0 and infinity. */
double
solveGrowing (const std::function<double (double)>& f, double value)
{
  double low = 0.0, high = 1.0;
  while (f (high) < value && high < 1e100)
    high *= 2.0;
  for (int i = 0; i < 200 && low < high; ++i) {
    const double middle = 0.5 * (low + high);
    (f (middle) < value ? low : high) = middle;
  }
  return high;
}

} // namespace

LabelledCloud
blueNoise (const Shape& shape, double spacing, std::uint64_t seed, Strata strata, const Tick& tick)
{
  if (!(spacing > 0.0))
    throw std::invalid_argument ("the spacing of " + shape.name + " must be positive");
  if (!(expectedCount (shape, spacing) < 2e9))
    throw std::invalid_argument ("the spacing of " + shape.name +
                                 " is so small that it gives too many points");
  Random random (seed);
  PointGrid grid (spacing);
  LabelledCloud cloud;
  for (const Shape* part : partsOf (shape, strata)) {
    // The shape itself is nearly all of the work.
    const bool is_whole = part == &shape;
    addPoints (shape, coverShape (*part, spacing, grid, random, is_whole ? tick : Tick ()), !is_whole, cloud);
  }
  return cloud;
}

LabelledCloud
uniform (const Shape& shape, std::size_t count, std::uint64_t seed, Strata strata)
{
  const std::vector<const Shape*> parts = partsOf (shape, strata);
  // The density of a part is this to the power of its dimension, so that all are equally dense to the eye.
  const auto pointsAt = [&parts] (double per_length) {
    double sum = 0.0;
    for (const Shape* part : parts)
      sum += part->measure () * std::pow (per_length, part->dimension);
    return sum;
  };
  const double per_length = solveGrowing (pointsAt, static_cast<double> (count));

  Random random (seed);
  LabelledCloud cloud;
  for (const Shape* part : parts) {
    const std::size_t left = count - cloud.size ();
    const double share = part->measure () * std::pow (per_length, part->dimension);
    const bool is_whole = part == &shape;
    const std::size_t points =
      is_whole ? left : std::min (left, static_cast<std::size_t> (std::lround (share)));
    const UniformDraw draw (*part);
    std::vector<Eigen::Vector3d> drawn;
    for (std::size_t i = 0; i < points; ++i)
      drawn.push_back (part->dimension == 0 ? part->point (i, Eigen::Vector3d::Zero ()) : draw (random));
    addPoints (shape, drawn, !is_whole, cloud);
  }
  return cloud;
}

LabelledCloud
epsilonSample (const Shape& shape, double eps, std::uint64_t seed)
{
  if (!(eps > 0.0))
    throw std::invalid_argument ("eps must be positive");
  if (!(shape.feature_size > 0.0) || std::isinf (shape.feature_size))
    throw std::invalid_argument ("the local feature size of " + shape.name + " is not known");
  // Blue noise leaves places that are a thousandth further away than its spacing.
  return blueNoise (shape, eps * shape.feature_size / 1.001, seed);
}

double
expectedCount (const Shape& shape, double spacing)
{
  double count = 0.0;
  for (const Shape* part : partsOf (shape, Strata::SAMPLED)) {
    const auto dimension = static_cast<std::size_t> (part->dimension);
    count += POINTS_PER_UNIT[dimension] * part->measure () / std::pow (spacing, part->dimension);
  }
  return count;
}

double
spacingFor (const Shape& shape, std::size_t count)
{
  const auto points = [&shape] (double per_length) { return expectedCount (shape, 1.0 / per_length); };
  return 1.0 / solveGrowing (points, static_cast<double> (count));
}

} // namespace generate
