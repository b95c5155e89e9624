#include "delaunay/sampled_complex.h"

#include <thread>

namespace pcl {
namespace manifold {

Status
makeSamples (const Eigen::Matrix3Xd& points, const pcl::Indices& indices, double resolution,
             const Thinning& thinning, StageLog& log, std::shared_ptr<const SampleSet>& samples)
{
  if (!log.begin ("sample set", 0.0f))
    return Status::CANCELLED;
  auto made = std::make_shared<SampleSet> ();
  const Status status = makeSampleSet (points, indices, thinning, resolution, *made);
  if (status == Status::OK)
    samples = made;
  return status;
}

Status
triangulateSamples (const std::shared_ptr<const SampleSet>& samples,
                    const std::shared_ptr<const DelaunayComplex>& given, unsigned int threads, StageLog& log,
                    std::shared_ptr<const DelaunayComplex>& complex)
{
  if (!log.begin ("delaunay triangulation", 0.1f))
    return Status::CANCELLED;
  complex =
    given && isOf (*given, *samples)
      ? given
      : computeDelaunayComplex (samples, threads == 0 ? std::thread::hardware_concurrency () : threads);
  return Status::OK;
}

bool
isOf (const DelaunayComplex& complex, const SampleSet& samples)
{
  return complex.samples && complex.samples->size () == samples.size () &&
         complex.samples->points == samples.points && complex.samples->origin == samples.origin &&
         complex.samples->scale == samples.scale && complex.samples->input_index == samples.input_index &&
         complex.samples->sample_of == samples.sample_of;
}

} // namespace manifold
} // namespace pcl
