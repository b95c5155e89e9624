#pragma once

#include <pcl/manifold/sample_set.h>
#include <pcl/manifold/simplicial_complex.h>

namespace pcl {
namespace manifold {

/** From indices of samples to those of the user's cloud. */
void toInput (const SampleSet& samples, SimplicialComplex& shape);

} // namespace manifold
} // namespace pcl
