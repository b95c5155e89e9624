#include "fixed_point/facet_flags.h"

namespace pcl {
namespace manifold {

FacetFlags
noFacets (const DelaunayComplex& complex)
{
  return {std::vector<std::uint8_t> (complex.cells.size (), 0)};
}

Facet
canonicalFacet (const DelaunayComplex& complex, const Facet& facet)
{
  const std::int32_t neighbor = complex.neighbors[facet.cell][facet.facet];
  return facet.cell < neighbor ? facet : Facet{neighbor, mirrorFacet (complex, facet.cell, facet.facet)};
}

bool
setFacet (const DelaunayComplex& complex, const Facet& facet, FacetFlags& flags)
{
  if (flags.contains (facet.cell, facet.facet))
    return false;
  flags.mask[facet.cell] |= static_cast<std::uint8_t> (1 << facet.facet);
  flags.mask[complex.neighbors[facet.cell][facet.facet]] |=
    static_cast<std::uint8_t> (1 << mirrorFacet (complex, facet.cell, facet.facet));
  return true;
}

std::vector<Facet>
facetsOf (const DelaunayComplex& complex, const FacetFlags& flags)
{
  std::vector<Facet> facets;
  for (std::size_t i = 0; i < flags.mask.size (); ++i) {
    const auto cell = static_cast<std::int32_t> (i);
    for (int k = 0; flags.mask[i] != 0 && k < 4; ++k)
      if (flags.contains (cell, k) && cell < complex.neighbors[i][k])
        facets.push_back ({cell, k});
  }
  return facets;
}

} // namespace manifold
} // namespace pcl
