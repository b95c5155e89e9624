#pragma once

#include <pcl/manifold/sample_dimensions.h>
#include <pcl/manifold/simplicial_complex.h>

namespace pcl {
namespace manifold {

/** All candidate simplices of COCONESHAPE as published (section 5 of Dey, Giesen, Goswami and Zhao): for
 * every sample of published dimension k the k-simplices at it dual to the Voronoi faces that its cocone
 * meets. Indices are those of samples; every simplex once, its samples in ascending order. */
SimplicialComplex collectCandidates (const SampleDimensions& dimensions);

} // namespace manifold
} // namespace pcl
