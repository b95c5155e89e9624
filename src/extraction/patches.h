#pragma once

#include "extraction/facet_set.h"

#include <cstdint>
#include <vector>

namespace pcl {
namespace manifold {

/** Triangles across which the colour changes and which are not in the surface, joined along the edges that
 * only they share. */
struct Patch
{
  std::vector<Facet> facets;
  int border = 0;    ///< edges that the patch shares with one triangle of the surface
  bool fills = true; ///< every other edge has two triangles of the patch: inserting it closes a hole
};

/** \param[in] others in ascending order of cell and facet; each cell is the one with the smaller number
 * Patches come in the order of their first triangles. */
std::vector<Patch> findPatches (const DelaunayComplex& complex, const std::vector<std::uint8_t>& colors,
                                const FacetSet& surface, const std::vector<Facet>& others);

} // namespace manifold
} // namespace pcl
