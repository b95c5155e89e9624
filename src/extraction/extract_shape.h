#pragma once

#include <pcl/manifold/detail/sample_dimensions.h>
#include <pcl/manifold/detail/stage_log.h>
#include <pcl/manifold/simplicial_complex.h>

namespace pcl {
namespace manifold {

/** Manifold extraction of COCONESHAPE, for curves, surfaces and solids, from the published dimensions.
 * \param[in] watertight closes every surface
 * \param[in,out] log told of each stage; where it says that the computation was cancelled, the result is
 * empty \return indices are those of samples; triangles are oriented consistently where that is possible */
SimplicialComplex extractShape (const SampleDimensions& dimensions, bool watertight, StageLog& log);

} // namespace manifold
} // namespace pcl
