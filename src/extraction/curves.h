#pragma once

#include "extraction/facet_set.h"
#include "extraction/sample_roles.h"

#include <array>
#include <cstdint>
#include <vector>

namespace pcl {
namespace manifold {

/** Polylines through the curve samples: of the candidate edges between them the shortest first, at most two
 * at a sample, and those two to different sides of it (an angle of more than 90 degrees). Edges that are
 * merely a side of a triangle of the surface or of a solid cell are left out. Every edge with the smaller
 * sample first, shortest edge first. */
std::vector<std::array<std::int32_t, 2>> extractCurves (const SampleDimensions& dimensions,
                                                        const std::vector<Role>& roles,
                                                        const FacetSet& surface,
                                                        const std::vector<std::uint8_t>& solid);

} // namespace manifold
} // namespace pcl
