#include <pcl/manifold/detail/detect_dimensions.h>

#include "common/guarded.h"
#include "common/parallel.h"
#include "voronoi/dimension.h"

#include <algorithm>
#include <thread>

namespace pcl {
namespace manifold {

namespace {

// Whether a triangulation that the user handed in is one of these samples.
bool
isOf (const DelaunayComplex& complex, const SampleSet& samples)
{
  return complex.samples && complex.samples->size () == samples.size () &&
         complex.samples->points == samples.points && complex.samples->origin == samples.origin &&
         complex.samples->scale == samples.scale && complex.samples->input_index == samples.input_index &&
         complex.samples->sample_of == samples.sample_of;
}

Status
detect (const Eigen::Matrix3Xd& points, const pcl::Indices& indices, double resolution,
        const DimensionParameters& parameters, StageLog& log, std::shared_ptr<const SampleDimensions>& result)
{
  if (!(parameters.rho > 0.0 && parameters.rho <= 1.0))
    return Status::PARAMETER_OUT_OF_RANGE;
  if (!log.begin ("sample set", 0.0f))
    return Status::CANCELLED;
  auto samples = std::make_shared<SampleSet> ();
  const Status status = makeSampleSet (points, indices, parameters.thinning, resolution, *samples);
  if (status != Status::OK)
    return status;

  if (parameters.dimensions && parameters.dimensions->complex &&
      isOf (*parameters.dimensions->complex, *samples)) {
    result = parameters.dimensions;
    return log.begin ("", 0.7f) ? Status::OK : Status::CANCELLED;
  }

  if (!log.begin ("delaunay triangulation", 0.1f))
    return Status::CANCELLED;
  std::shared_ptr<const DelaunayComplex> complex = parameters.complex;
  if (!complex || !isOf (*complex, *samples))
    complex = computeDelaunayComplex (samples, parameters.threads == 0 ? std::thread::hardware_concurrency ()
                                                                       : parameters.threads);

  if (!log.begin ("dimension", 0.6f))
    return Status::CANCELLED;
  auto dimensions = std::make_shared<SampleDimensions> (computeDimensions (complex, parameters.rho));

  if (!log.begin ("manifold dimension", 0.65f))
    return Status::CANCELLED;
  decideManifoldDimensions (*dimensions);
  if (!log.begin ("", 0.7f))
    return Status::CANCELLED;
  result = dimensions;
  return Status::OK;
}

} // namespace

Status
detectDimensions (const Eigen::Matrix3Xd& points, const pcl::Indices& indices, double resolution,
                  const DimensionParameters& parameters, StageLog& log,
                  std::shared_ptr<const SampleDimensions>& result) noexcept
{
  result.reset ();
  return guarded ([&] {
    Status status = Status::OK;
    withThreads (parameters.threads,
                 [&] { status = detect (points, indices, resolution, parameters, log, result); });
    return status;
  });
}

} // namespace manifold
} // namespace pcl
