#include <pcl/manifold/bulk_box.h>
#include <pcl/manifold/sample_set.h>

#include "common/index_limit.h"
#include "common/large_pages.h"
#include "common/parallel.h"
#include "points/nearest_neighbors.h"
#include "points/no_measurement.h"
#include "points/space_filling_order.h"
#include "points/spacing.h"
#include "points/thinning.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pcl {
namespace manifold {

namespace {

// Far from the origin: the centre of the bulk's box is this many times farther away than the box is large.
constexpr double FAR_FACTOR = 16.0;
// Fewer steps of the coordinates' type between neighbours than this, and rounding decides the shape.
constexpr double MIN_STEPS = 4.0;

// Where the bulk of the cloud is so far from the origin that the subtraction is exact, a point in its middle;
// else zero.
Eigen::Vector3d
chooseOrigin (const Eigen::AlignedBox3d& bulk)
{
  const Eigen::Vector3d center = 0.5 * bulk.min () + 0.5 * bulk.max ();
  const double extent = bulk.sizes ().maxCoeff ();
  Eigen::Vector3d origin = Eigen::Vector3d::Zero ();
  for (int axis = 0; axis < 3; ++axis)
    if (std::abs (center[axis]) > FAR_FACTOR * extent)
      origin[axis] = center[axis]; // every coordinate of the bulk is between half and twice as large
  return origin;
}

// The power of two that makes an extent lie in [1, 2).
double
scaleOf (double extent)
{
  return extent > 0.0 ? std::ldexp (1.0, std::clamp (-std::ilogb (extent), -1000, 1000)) : 1.0;
}

// Far away the steps of the type may be as large as the spacing. What counts is the step at each point: there
// may be strays farther away, or nearer. Only where it can be so is the spacing worth a search: by the extent
// alone no cloud of n points could have more steps than that.
bool
isTooCoarse (const SampleSet& samples, const Eigen::AlignedBox3d& bulk, double resolution)
{
  const double largest = std::max (bulk.min ().cwiseAbs ().maxCoeff (), bulk.max ().cwiseAbs ().maxCoeff ());
  if (bulk.sizes ().maxCoeff () > largest * resolution * 1e5)
    return false;
  const std::vector<NearestDistance> distances = nearestDistances (samples.points);
  const auto unresolved =
    std::count_if (distances.begin (), distances.end (), [&] (const NearestDistance& d) {
      const Eigen::Vector3d point = samples.points.col (d.point) + samples.origin * samples.scale;
      return d.distance < MIN_STEPS * point.cwiseAbs ().maxCoeff () * resolution;
    });
  return 2 * static_cast<std::size_t> (unresolved) > distances.size ();
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

// Makes every distinct point a sample, in their order along a space-filling curve, and answers how many
// points each of them stands for.
std::vector<std::int32_t>
mergeDuplicates (const Eigen::Matrix3Xd& points, const Eigen::AlignedBox3d& bulk,
                 const std::vector<std::int32_t>& number, const pcl::Indices& indices, SampleSet& samples)
{
  const std::vector<std::int32_t> order = spaceFillingOrder (points, bulk);
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
  std::vector<std::int32_t> counts;
  if (samples.duplicates > 0) {
    counts.resize (static_cast<std::size_t> (count));
    for (const std::int32_t sample : sample_at)
      ++counts[sample];
  }
  return counts;
}

// Leaves out the sample that stands for points without measurement, if there is one.
void
leaveOutNoMeasurement (const std::vector<std::int32_t>& counts, SampleSet& samples)
{
  if (counts.empty ())
    return;
  const Eigen::Vector3d zero = (Eigen::Vector3d::Zero () - samples.origin) * samples.scale;
  const std::int32_t place = findNoMeasurement (samples.points, counts, zero);
  if (place < 0)
    return;
  samples.no_measurement = static_cast<std::size_t> (counts[place]);
  samples.duplicates -= samples.no_measurement - 1;
  samples.input_index.erase (samples.input_index.begin () + place);
  for (std::int32_t& sample : samples.sample_of)
    sample = sample == place ? -1 : sample - (sample > place ? 1 : 0);
  const auto behind = samples.points.reshaped ().begin () + 3 * (static_cast<Eigen::Index> (place) + 1);
  std::copy (behind, samples.points.reshaped ().end (), behind - 3);
  samples.points.conservativeResize (Eigen::NoChange, samples.points.cols () - 1);
  // It may have been far from all others.
  const double extent =
    (samples.points.rowwise ().maxCoeff () - samples.points.rowwise ().minCoeff ()).maxCoeff ();
  const double scale = scaleOf (extent / samples.scale);
  samples.points *= scale / samples.scale;
  samples.scale = scale;
}

} // namespace

Status
makeSampleSet (const Eigen::Ref<const Eigen::Matrix3Xd>& points, const pcl::Indices& indices,
               const Thinning& thinning, double resolution, SampleSet& samples)
{
  samples = SampleSet ();
  if (thinning.neighbors < 0 || !(thinning.distance >= 0.0) || !std::isfinite (thinning.distance))
    return Status::PARAMETER_OUT_OF_RANGE;
  if (!fitsIndices (static_cast<std::uint64_t> (points.cols ())))
    return Status::TOO_MANY_POINTS;

  std::vector<std::int32_t> finite;
  finite.reserve (static_cast<std::size_t> (points.cols ()));
  Eigen::AlignedBox3d box;
  for (Eigen::Index i = 0; i < points.cols (); ++i)
    if (points.col (i).allFinite ()) {
      finite.push_back (static_cast<std::int32_t> (i));
      box.extend (points.col (i));
    }
  if (finite.empty ())
    return Status::NO_INPUT;
  if (!box.sizes ().allFinite ())
    return Status::INPUT_OUT_OF_RANGE;

  SampleSet result;
  result.non_finite = static_cast<std::size_t> (points.cols ()) - finite.size ();
  assignLarge (result.sample_of, static_cast<std::size_t> (points.cols ()), -1);
  const Eigen::AlignedBox3d bulk = bulkBox (points);
  result.origin = chooseOrigin (bulk);
  result.scale = scaleOf (box.sizes ().maxCoeff ());
  const auto moved = [&result] (const Eigen::Vector3d& point) -> Eigen::Vector3d {
    // Adding zero turns -0 into 0, so that equal coordinates are equal bit for bit.
    return (point - result.origin) * result.scale + Eigen::Vector3d::Zero ();
  };

  Eigen::Matrix3Xd shifted;
  resizeLarge (shifted, 3, static_cast<Eigen::Index> (finite.size ()));
  parallelFor (finite.size (), [&] (std::size_t i) { shifted.col (i) = moved (points.col (finite[i])); });
  const std::vector<std::int32_t> counts = mergeDuplicates (
    shifted, Eigen::AlignedBox3d (moved (bulk.min ()), moved (bulk.max ())), finite, indices, result);
  leaveOutNoMeasurement (counts, result);
  if (isTooCoarse (result, bulk, resolution))
    return Status::INPUT_TOO_COARSE;
  keepOnly (chooseSamples (thinning, result), result);
  samples = std::move (result);
  return Status::OK;
}

} // namespace manifold
} // namespace pcl
