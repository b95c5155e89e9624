#pragma once

#include "extraction/facet_set.h"
#include "extraction/surface_candidates.h"

#include <cstdint>
#include <vector>

namespace pcl {
namespace manifold {

/** Replaces the surface where its colours tear it because it has one side only, as a Moebius band has: the
 * two colours have to meet somewhere, and there they change in the middle of free space, between cells whose
 * circumspheres are nearly the same. The cells are coloured again such that this happens elsewhere, and the
 * surface around the tear is taken from there.
 * \param[in] solid the cells that are certain to be inside of a solid, a flag per cell
 * \param[in] colors as they were before any repair, and torn, the facets where they change in free space
 * \return the number of samples at which the surface was replaced */
std::size_t mendOneSided (const SurfaceCandidates& candidates, const std::vector<std::uint8_t>& solid,
                          const std::vector<std::uint8_t>& colors, const std::vector<Facet>& torn,
                          FacetSet& surface);

} // namespace manifold
} // namespace pcl
