#pragma once

#include <pcl/manifold/sample_dimensions.h>

#include <memory>

namespace pcl {
namespace manifold {

/** DIMENSION as published, at every sample: dimension, confidence, heights, normals and tangents.
 * \param[in] rho in (0, 1]: heights at least H1 / rho count as normal directions */
SampleDimensions computeDimensions (const std::shared_ptr<const DelaunayComplex>& complex, double rho);

/** Manifold dimension and boundary from the published labels of each sample and of its nearest samples. */
void decideManifoldDimensions (SampleDimensions& dimensions);

} // namespace manifold
} // namespace pcl
