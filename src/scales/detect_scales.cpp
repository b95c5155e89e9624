#include <pcl/manifold/detail/guarded.h>
#include <pcl/manifold/scale_dimensions.h>

#include "common/parallel.h"
#include "delaunay/sampled_complex.h"
#include "points/nearest_neighbors.h"
#include "scales/curve_measures.h"
#include "scales/level_evidence.h"
#include "scales/persistence.h"
#include "scales/scale_ladder.h"
#include "scales/sensor_coordinates.h"
#include "voronoi/dimension.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <thread>

namespace pcl {
namespace manifold {

namespace {

bool
areValid (const ScaleParameters& scales)
{
  // The scales of a frame are those of its beams, which differ from place to place.
  if (scales.sensor_origin && (scales.from > 0.0 || scales.to > 0.0))
    return false;
  return std::isfinite (scales.from) && std::isfinite (scales.to) && scales.from >= 0.0 && scales.to >= 0.0 &&
         (scales.to == 0.0 || scales.from <= scales.to) &&
         (!scales.sensor_origin || scales.sensor_origin->allFinite ());
}

// The sensor's place in the coordinates of the samples, if it is known, or if they are a frame of one at 0 0
// 0, where the drivers of spinning lidars put it.
std::optional<SensorCoordinates>
sensorIn (const SampleSet& samples, const std::vector<pcl::index_t>& neighbors, const ScaleParameters& scales)
{
  const auto inSamples = [&samples] (const Eigen::Vector3d& origin) -> Eigen::Vector3d {
    return (origin - samples.origin) * samples.scale;
  };
  if (scales.sensor_origin)
    return SensorCoordinates (samples.points, inSamples (*scales.sensor_origin));
  const Eigen::Vector3d zero = inSamples (Eigen::Vector3d::Zero ());
  const bool asked = scales.from > 0.0 || scales.to > 0.0;
  if (asked || !hasRings (samples.points, neighbors, zero))
    return std::nullopt;
  return SensorCoordinates (samples.points, zero);
}

// How far apart scan lines are: the median of twice H2 over the samples that are labelled as ones of curves
// beside which there is a far greater H3, as on a surface whose lines they are. 0 where there are few of
// these.
double
scanLineSpacing (const SampleDimensions& dimensions, double rho)
{
  constexpr double SHARE = 0.1;
  std::vector<double> spacings;
  for (std::size_t i = 0; i < dimensions.dimension.size (); ++i) {
    const Eigen::Vector3d heights = dimensions.heights.col (static_cast<Eigen::Index> (i));
    if (dimensions.dimension[i] == 1 && std::isfinite (heights[1]) && heights[1] < rho * heights[2])
      spacings.push_back (2.0 * heights[1]);
  }
  if (static_cast<double> (spacings.size ()) < SHARE * static_cast<double> (dimensions.dimension.size ()))
    return 0.0;
  const auto middle = spacings.begin () + static_cast<std::ptrdiff_t> (spacings.size () / 2);
  std::nth_element (spacings.begin (), middle, spacings.end ());
  return *middle;
}

std::shared_ptr<const SampleDimensions>
dimensionsOf (const std::shared_ptr<const SampleSet>& samples, double rho, unsigned int threads)
{
  auto dimensions =
    std::make_shared<SampleDimensions> (computeDimensions (computeDelaunayComplex (samples, threads), rho));
  decideManifoldDimensions (*dimensions);
  return dimensions;
}

// The samples of a level, or null where not all of its centres can be told apart from nothing: they coincide,
// or overflow.
std::shared_ptr<const SampleSet>
samplesOf (const ScaleLevel& level)
{
  auto samples = std::make_shared<SampleSet> ();
  const double exact = std::numeric_limits<double>::epsilon () / 2.0;
  const Status status = makeSampleSet (level.centers, {}, Thinning (), exact, *samples);
  const auto missing = [] (std::int32_t sample) { return sample < 0; };
  if (status != Status::OK || std::any_of (samples->sample_of.begin (), samples->sample_of.end (), missing))
    return nullptr;
  return samples;
}

LevelEvidence
evidenceOf (const ScaleLevel& level, const std::shared_ptr<const SampleDimensions>& dimensions)
{
  const SampleSet& samples = *dimensions->complex->samples;
  LevelEvidence evidence = evaluateLevel (*dimensions, samples.sample_of, level.spacing * samples.scale);
  evidence.spacing = level.spacing;
  return evidence;
}

Status
detect (const Eigen::Matrix3Xd& points, const pcl::Indices& indices, double resolution,
        const DimensionParameters& parameters, const ScaleParameters& scales, StageLog& log,
        ScaleDimensions& result)
{
  if (!(parameters.rho > 0.0 && parameters.rho <= 1.0) || !areValid (scales))
    return Status::PARAMETER_OUT_OF_RANGE;
  const unsigned int threads =
    parameters.threads == 0 ? std::thread::hardware_concurrency () : parameters.threads;
  const Status status = makeSamples (points, indices, resolution, parameters.thinning, log, result.samples);
  if (status != Status::OK)
    return status;
  const SampleSet& samples = *result.samples;

  if (!log.begin ("scales", 0.05f))
    return Status::CANCELLED;
  std::vector<pcl::index_t> neighbors;
  if (samples.size () > NEAREST)
    neighbors = kNearestNeighbors (samples.points, NEAREST);
  const std::optional<SensorCoordinates> sensor = sensorIn (samples, neighbors, scales);
  if (sensor)
    result.sensor_origin = sensor->origin () / samples.scale + samples.origin;
  const ScaleRange range{scales.from * samples.scale, scales.to * samples.scale};
  const std::vector<ScaleLevel> levels =
    makeLadder (sensor ? sensor->toSensor (samples.points) : samples.points, range);

  // Coarse levels first, so that the largest triangulation is alone in memory.
  std::vector<LevelEvidence> evidence (levels.size ());
  double finest = scales.from * samples.scale;
  if (sensor) {
    if (!log.begin ("scan lines", 0.15f))
      return Status::CANCELLED;
    const std::shared_ptr<const SampleSet> seen = samplesOf (levels.front ());
    if (!seen)
      return Status::INPUT_OUT_OF_RANGE; // from so far away all points are one
    const std::shared_ptr<const SampleDimensions> dimensions = dimensionsOf (seen, parameters.rho, threads);
    finest = std::max (finest, 0.5 * scanLineSpacing (*dimensions, parameters.rho) / seen->scale);
    if (levels.size () == 1 || levels.front ().spacing >= finest)
      evidence.front () = evidenceOf (levels.front (), dimensions);
  }
  if (!log.begin ("levels", 0.3f))
    return Status::CANCELLED;
  for (std::size_t level = levels.size (); level-- > 1;) {
    if (levels[level].spacing < finest && level + 1 < levels.size ())
      break;
    if (!log.proceed (0.3f + 0.3f / static_cast<float> (level)))
      return Status::CANCELLED;
    if (const std::shared_ptr<const SampleSet> there = samplesOf (levels[level]))
      evidence[level] = evidenceOf (levels[level], dimensionsOf (there, parameters.rho, threads));
  }
  if (!sensor && (levels.size () == 1 || levels.front ().spacing >= finest)) {
    if (!log.begin ("finest level", 0.6f))
      return Status::CANCELLED;
    result.finest = dimensionsOf (result.samples, parameters.rho, threads);
    std::vector<std::int32_t> itself (static_cast<std::size_t> (samples.size ()));
    std::iota (itself.begin (), itself.end (), 0);
    evidence.front () = evaluateLevel (*result.finest, itself, levels.front ().spacing);
    evidence.front ().spacing = levels.front ().spacing;
  }
  const auto is_empty = [] (const LevelEvidence& level) { return level.dimension.empty (); };
  if (std::all_of (evidence.begin (), evidence.end (), is_empty))
    return Status::INPUT_OUT_OF_RANGE;

  if (!log.begin ("persistence", 0.9f))
    return Status::CANCELLED;
  PersistentLabels labels = choosePersistent (levels, evidence, neighbors);
  if (sensor)
    toSpace (*sensor, samples.points, labels);
  result.manifold_dimension = std::move (labels.manifold_dimension);
  result.dimension = std::move (labels.dimension);
  result.boundary = std::move (labels.boundary);
  result.confidence = std::move (labels.confidence);
  result.persistence = std::move (labels.persistence);
  result.scale = std::move (labels.scale);
  for (float& scale : result.scale)
    scale = static_cast<float> (scale / samples.scale);
  result.curves = measureCurves (samples, labels);
  result.curve = std::move (labels.curve);
  result.tangents = std::move (labels.tangent);
  return log.begin ("", 1.0f) ? Status::OK : Status::CANCELLED;
}

} // namespace

Status
detectScales (const Eigen::Matrix3Xd& points, const pcl::Indices& indices, double resolution,
              const DimensionParameters& parameters, const ScaleParameters& scales, StageLog& log,
              std::shared_ptr<const ScaleDimensions>& result) noexcept
{
  result.reset ();
  return guarded ([&] {
    auto made = std::make_shared<ScaleDimensions> ();
    Status status = Status::OK;
    withThreads (parameters.threads,
                 [&] { status = detect (points, indices, resolution, parameters, scales, log, *made); });
    if (status == Status::OK)
      result = made;
    return status;
  });
}

} // namespace manifold
} // namespace pcl
