#include <pcl/manifold/detail/guarded.h>
#include <pcl/manifold/detect_dimensions.h>

#include "common/parallel.h"
#include "delaunay/sampled_complex.h"
#include "voronoi/dimension.h"

namespace pcl {
namespace manifold {

namespace {

Status
detect (const Eigen::Matrix3Xd& points, const pcl::Indices& indices, double resolution,
        const DimensionParameters& parameters, StageLog& log, std::shared_ptr<const SampleDimensions>& result)
{
  if (!(parameters.rho > 0.0 && parameters.rho <= 1.0))
    return Status::PARAMETER_OUT_OF_RANGE;
  std::shared_ptr<const SampleSet> samples;
  Status status = makeSamples (points, indices, resolution, parameters.thinning, log, samples);
  if (status != Status::OK)
    return status;

  if (parameters.dimensions && parameters.dimensions->complex &&
      isOf (*parameters.dimensions->complex, *samples)) {
    result = parameters.dimensions;
    return log.begin ("", 0.7f) ? Status::OK : Status::CANCELLED;
  }

  std::shared_ptr<const DelaunayComplex> complex;
  status = triangulateSamples (samples, parameters.complex, parameters.threads, log, complex);
  if (status != Status::OK)
    return status;

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
  const Status status = guarded ([&] {
    Status answer = Status::OK;
    withThreads (parameters.threads,
                 [&] { answer = detect (points, indices, resolution, parameters, log, result); });
    return answer;
  });
  if (status != Status::OK)
    result.reset ();
  return status;
}

} // namespace manifold
} // namespace pcl
