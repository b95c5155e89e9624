#pragma once

#include "extraction/facet_set.h"

#include <cstdint>
#include <vector>

namespace pcl {
namespace manifold {

/** Erases triangles at the given samples until the set is manifold there and stays so at their neighbours: at
 * each sample the largest fan is kept, and of more than two triangles at an edge those with the smallest
 * circumspheres. */
void eraseToManifold (const std::vector<std::int32_t>& samples, FacetSet& surface);

} // namespace manifold
} // namespace pcl
