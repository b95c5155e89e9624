#pragma once

#include "extraction/facet_set.h"
#include "extraction/surface_candidates.h"

#include <cstdint>
#include <vector>

namespace pcl {
namespace manifold {

/** The triangles across which the colour changes, all of them: closed where the infinite cells have one
 * colour. */
FacetSet closedSurface (const DelaunayComplex& complex, const std::vector<std::uint8_t>& colors);

/** The candidates among the triangles across which the colour changes, and those others that fill no more
 * than a small hole between them; manifold at every sample.
 *
 * Triangles that are no candidates span what was not sampled: the base of a scan that nobody saw, or free
 * space where an open sheet has no other side. */
FacetSet openSurface (const SurfaceCandidates& candidates, const std::vector<std::uint8_t>& colors);

} // namespace manifold
} // namespace pcl
