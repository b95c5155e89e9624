#include <pcl/manifold/detail/guarded.h>
#include <pcl/manifold/reconstruct_shape.h>

#include "common/parallel.h"
#include "extraction/candidates.h"
#include "extraction/extract_shape.h"
#include "extraction/to_input.h"

#include <utility>

namespace pcl {
namespace manifold {

namespace {

Status
reconstruct (const Eigen::Matrix3Xd& points, const pcl::Indices& indices, double resolution,
             const ShapeParameters& parameters, StageLog& log,
             std::shared_ptr<const SampleDimensions>& dimensions, SimplicialComplex& shape)
{
  const Status status = detectDimensions (points, indices, resolution, parameters.dimension, log, dimensions);
  if (status != Status::OK)
    return status;
  if (dimensions->complex->affine_dimension < 1)
    return Status::DIMENSION_TOO_LOW;
  SimplicialComplex extracted = extractShape (*dimensions, parameters.watertight, log);
  if (!log.begin ("", 1.0f))
    return Status::CANCELLED;
  toInput (*dimensions->complex->samples, extracted);
  shape = std::move (extracted);
  return Status::OK;
}

} // namespace

Status
reconstructShape (const Eigen::Matrix3Xd& points, const pcl::Indices& indices, double resolution,
                  const ShapeParameters& parameters, StageLog& log,
                  std::shared_ptr<const SampleDimensions>& dimensions, SimplicialComplex& shape) noexcept
{
  dimensions.reset ();
  shape.clear ();
  const Status status = guarded ([&] {
    Status result = Status::OK;
    withThreads (parameters.dimension.threads, [&] {
      result = reconstruct (points, indices, resolution, parameters, log, dimensions, shape);
    });
    return result;
  });
  if (status != Status::OK)
    dimensions.reset ();
  return status;
}

SimplicialComplex
candidateShape (const SampleDimensions& dimensions)
{
  SimplicialComplex candidates = collectCandidates (dimensions);
  toInput (*dimensions.complex->samples, candidates);
  return candidates;
}

} // namespace manifold
} // namespace pcl
