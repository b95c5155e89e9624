#pragma once

#include "extraction/facet_set.h"

#include <cstdint>
#include <vector>

namespace pcl {
namespace manifold {

/** The facets across which the colour changes, also those with an infinite vertex, in ascending order; each
 * as a facet of its cell with the smaller number. */
std::vector<Facet> colorChanges (const DelaunayComplex& complex, const std::vector<std::uint8_t>& colors);

/** Whether a facet has the infinite vertex. */
bool hasInfiniteVertex (const DelaunayComplex& complex, const Facet& facet);

} // namespace manifold
} // namespace pcl
