#pragma once

#include <pcl/manifold/fixed_point_complex.h>
#include <pcl/manifold/sample_dimensions.h>
#include <pcl/manifold/simplicial_complex.h>
#include <pcl/manifold/stage_log.h>

namespace pcl {
namespace manifold {

/** The candidates for surfaces of another method than COCONESHAPE. */
struct GivenCandidates
{
  const FacetFlags& facets;
  bool proved = false; ///< to hold a closed surface through all samples, if they enclose all of these
};

/** Manifold extraction of COCONESHAPE, for curves, surfaces and solids, from the published dimensions.
 * \param[in] watertight closes every surface
 * \param[in] given the candidates for surfaces of another method; null for those of COCONESHAPE
 * \param[in,out] log told of each stage; where it says that the computation was cancelled, the result is
 * empty
 * \return indices are those of samples; triangles are oriented consistently where that is possible */
SimplicialComplex extractShape (const SampleDimensions& dimensions, bool watertight, StageLog& log,
                                const GivenCandidates* given = nullptr);

} // namespace manifold
} // namespace pcl
