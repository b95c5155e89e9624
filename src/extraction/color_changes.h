#pragma once

#include "extraction/facet_set.h"

#include <cstdint>
#include <vector>

namespace pcl {
namespace manifold {

/** The facets across which the colour changes, also those with an infinite vertex, in ascending order; each
 * as a facet of its cell with the smaller number. */
std::vector<Facet> colorChanges (const DelaunayComplex& complex, const std::vector<std::uint8_t>& colors);

/** How many samples have cells of one colour only around them: the surface where the colour changes does not
 * pass through those. Parallel in the current arena. */
std::size_t countMissed (const DelaunayComplex& complex, const std::vector<std::uint8_t>& colors);

/** Whether a facet has the infinite vertex. */
bool hasInfiniteVertex (const DelaunayComplex& complex, const Facet& facet);

} // namespace manifold
} // namespace pcl
