#include <pcl/manifold/sample_set.h>

#include "common/large_pages.h"
#include "common/parallel.h"
#include "points/nearest_neighbors.h"
#include "points/space_filling_order.h"
#include "points/thinning.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace pcl {
namespace manifold {

namespace {

// Far from the origin: the centre of the bounding box is this many times farther away than the box is large.
constexpr double FAR_FACTOR = 16.0;
// Fewer steps of the coordinates' type between neighbours than this, and rounding decides the shape.
constexpr double MIN_STEPS = 4.0;

// Where the cloud is so far from the origin that the subtraction is exact, a point in its middle; else zero.
Eigen::Vector3d
chooseOrigin (const Eigen::Vector3d& low, const Eigen::Vector3d& high)
{
  const Eigen::Vector3d center = 0.5 * low + 0.5 * high;
  const double extent = (high - low).maxCoeff ();
  Eigen::Vector3d origin = Eigen::Vector3d::Zero ();
  for (int axis = 0; axis < 3; ++axis)
    if (std::abs (center[axis]) > FAR_FACTOR * extent)
      origin[axis] = center[axis]; // every coordinate is between half and twice as large
  return origin;
}

// Median distance from a sample to its nearest neighbour, over at most a thousand samples spread evenly.
double
medianSpacing (const Eigen::Matrix3Xd& points)
{
  if (points.cols () < 2)
    return std::numeric_limits<double>::infinity ();
  const std::vector<pcl::index_t> nearest = kNearestNeighbors (points, 1);
  std::vector<double> distances;
  const Eigen::Index step = std::max<Eigen::Index> (1, points.cols () / 1000);
  for (Eigen::Index i = 0; i < points.cols (); i += step)
    distances.push_back ((points.col (i) - points.col (nearest[i])).norm ());
  std::nth_element (distances.begin (), distances.begin () + distances.size () / 2, distances.end ());
  return distances[distances.size () / 2];
}

// Far away the steps of the type may be as large as the spacing. Only then is the spacing worth a search: by
// the extent alone no cloud of n points could have more steps than that.
bool
isTooCoarse (const SampleSet& samples, double largest, double resolution)
{
  const double step = largest * resolution * samples.scale;
  const double extent =
    (samples.points.rowwise ().maxCoeff () - samples.points.rowwise ().minCoeff ()).maxCoeff ();
  if (extent > step * 1e5)
    return false;
  return medianSpacing (samples.points) < MIN_STEPS * step;
}

// The points that have this flag.
Eigen::Matrix3Xd
pointsWith (const Eigen::Matrix3Xd& points, const std::vector<std::uint8_t>& flags, std::uint8_t flag)
{
  Eigen::Matrix3Xd result (3, std::count (flags.begin (), flags.end (), flag));
  Eigen::Index next = 0;
  for (std::size_t i = 0; i < flags.size (); ++i)
    if (flags[i] == flag)
      result.col (next++) = points.col (i);
  return result;
}

// A flag per sample: 1 = kept.
std::vector<std::uint8_t>
chooseSamples (const Thinning& thinning, const SampleSet& samples)
{
  std::vector<std::uint8_t> kept (static_cast<std::size_t> (samples.size ()), 1);
  if (thinning.distance > 0.0)
    kept = thinBySpacing (samples.points, thinning.distance * samples.scale);
  if (thinning.neighbors > 0) {
    const std::vector<std::uint8_t> of_kept =
      thinByNeighbors (pointsWith (samples.points, kept, 1), thinning.neighbors);
    auto next = of_kept.begin ();
    for (std::uint8_t& flag : kept)
      if (flag != 0)
        flag = *next++;
  }
  return kept;
}

// Removes the samples that were not kept, and gives the points that they stood for to the nearest kept one.
void
keepOnly (const std::vector<std::uint8_t>& kept, SampleSet& samples)
{
  const auto n = static_cast<std::size_t> (samples.size ());
  samples.thinned = static_cast<std::size_t> (std::count (kept.begin (), kept.end (), 0));
  if (samples.thinned == 0)
    return;
  Eigen::Matrix3Xd kept_points = pointsWith (samples.points, kept, 1);
  const std::vector<std::int32_t> nearest = nearestPoints (kept_points, pointsWith (samples.points, kept, 0));
  auto next_nearest = nearest.begin ();
  pcl::Indices kept_index;
  std::vector<std::int32_t> new_sample (n);
  for (std::size_t i = 0; i < n; ++i) {
    new_sample[i] = kept[i] ? static_cast<std::int32_t> (kept_index.size ()) : *next_nearest++;
    if (kept[i])
      kept_index.push_back (samples.input_index[i]);
  }
  for (std::int32_t& sample : samples.sample_of)
    if (sample >= 0)
      sample = new_sample[sample];
  samples.points = std::move (kept_points);
  samples.input_index = std::move (kept_index);
}

// Makes every distinct point a sample, in their order along a space-filling curve.
void
mergeDuplicates (const Eigen::Matrix3Xd& points, const std::vector<std::int32_t>& number,
                 const pcl::Indices& indices, SampleSet& samples)
{
  const std::vector<std::int32_t> order = spaceFillingOrder (points);
  // Equal points follow each other: every one whose predecessor is another starts a sample.
  std::vector<std::int32_t> sample_at;
  assignLarge (sample_at, order.size ());
  parallelFor (order.size (), [&] (std::size_t i) {
    sample_at[i] = i > 0 && points.col (order[i]) != points.col (order[i - 1]) ? 1 : 0;
  });
  std::partial_sum (sample_at.begin (), sample_at.end (), sample_at.begin ());

  const std::int32_t count = sample_at.back () + 1;
  resizeLarge (samples.points, 3, count);
  assignLarge (samples.input_index, static_cast<std::size_t> (count));
  samples.duplicates = order.size () - static_cast<std::size_t> (count);
  parallelFor (order.size (), [&] (std::size_t i) {
    const std::int32_t sample = sample_at[i];
    const std::int32_t original = number[order[i]];
    samples.sample_of[original] = sample;
    if (i > 0 && sample == sample_at[i - 1])
      return;
    samples.points.col (sample) = points.col (order[i]);
    samples.input_index[sample] = indices.empty () ? original : indices[original];
  });
}

} // namespace

Status
makeSampleSet (const Eigen::Ref<const Eigen::Matrix3Xd>& points, const pcl::Indices& indices,
               const Thinning& thinning, double resolution, SampleSet& samples)
{
  samples = SampleSet ();
  if (thinning.neighbors < 0 || !(thinning.distance >= 0.0) || !std::isfinite (thinning.distance))
    return Status::PARAMETER_OUT_OF_RANGE;

  std::vector<std::int32_t> finite;
  finite.reserve (static_cast<std::size_t> (points.cols ()));
  for (Eigen::Index i = 0; i < points.cols (); ++i)
    if (points.col (i).allFinite ())
      finite.push_back (static_cast<std::int32_t> (i));
  if (finite.empty ())
    return Status::NO_INPUT;

  Eigen::Vector3d low = points.col (finite.front ());
  Eigen::Vector3d high = low;
  for (const std::int32_t i : finite) {
    low = low.cwiseMin (points.col (i));
    high = high.cwiseMax (points.col (i));
  }
  if (!(high - low).allFinite ())
    return Status::INPUT_OUT_OF_RANGE;

  SampleSet result;
  result.non_finite = static_cast<std::size_t> (points.cols ()) - finite.size ();
  assignLarge (result.sample_of, static_cast<std::size_t> (points.cols ()), -1);
  result.origin = chooseOrigin (low, high);
  const double extent = (high - low).maxCoeff ();
  if (extent > 0.0)
    result.scale = std::ldexp (1.0, std::clamp (-std::ilogb (extent), -1000, 1000));

  Eigen::Matrix3Xd shifted;
  resizeLarge (shifted, 3, static_cast<Eigen::Index> (finite.size ()));
  parallelFor (finite.size (), [&] (std::size_t i) {
    // Adding zero turns -0 into 0, so that equal coordinates are equal bit for bit.
    shifted.col (i) =
      ((points.col (finite[i]) - result.origin) * result.scale + Eigen::Vector3d::Zero ()).eval ();
  });

  mergeDuplicates (shifted, finite, indices, result);
  const double largest = std::max (low.cwiseAbs ().maxCoeff (), high.cwiseAbs ().maxCoeff ());
  if (isTooCoarse (result, largest, resolution))
    return Status::INPUT_TOO_COARSE;
  keepOnly (chooseSamples (thinning, result), result);
  samples = std::move (result);
  return Status::OK;
}

} // namespace manifold
} // namespace pcl
