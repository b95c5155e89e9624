#pragma once

#include <pcl/manifold/delaunay_complex.h>
#include <pcl/manifold/stage_log.h>

#include <memory>

namespace pcl {
namespace manifold {

/** The stage "sample set" of a recipe: see makeSampleSet. */
Status makeSamples (const Eigen::Matrix3Xd& points, const pcl::Indices& indices, double resolution,
                    const Thinning& thinning, StageLog& log, std::shared_ptr<const SampleSet>& samples);

/** The stage "delaunay triangulation" of a recipe.
 * \param[in] given taken over if it is one of these samples; may be null
 * \param[in] threads 0 = all cores */
Status triangulateSamples (const std::shared_ptr<const SampleSet>& samples,
                           const std::shared_ptr<const DelaunayComplex>& given, unsigned int threads,
                           StageLog& log, std::shared_ptr<const DelaunayComplex>& complex);

/** Whether a triangulation that the user handed in is one of these samples. */
bool isOf (const DelaunayComplex& complex, const SampleSet& samples);

} // namespace manifold
} // namespace pcl
