#include "extraction/patches.h"

#include "complex/disjoint_sets.h"

#include <algorithm>

namespace pcl {
namespace manifold {

namespace {

// Turns around the edge (u, v) from a cell across one of its two facets at the edge, and calls
// visit (cell, facet) for every facet at the edge after the first until it is back.
template <typename Visit>
void
aroundEdge (const DelaunayComplex& complex, std::int32_t u, std::int32_t v, std::int32_t cell, int facet,
            const Visit& visit)
{
  const std::int32_t start = cell;
  const int start_facet = facet;
  do {
    const int entry = mirrorFacet (complex, cell, facet);
    cell = complex.neighbors[cell][facet];
    // Of the two facets at the edge take the one that was not entered.
    for (int k = 0; k < 4; ++k)
      if (k != entry && complex.cells[cell][k] != u && complex.cells[cell][k] != v) {
        facet = k;
        break;
      }
    if (cell != start || facet != start_facet)
      visit (cell, facet);
  } while (cell != start || facet != start_facet);
}

} // namespace

std::vector<Patch>
findPatches (const DelaunayComplex& complex, const std::vector<std::uint8_t>& colors, const FacetSet& surface,
             const std::vector<Facet>& others)
{
  const auto indexOf = [&] (std::int32_t cell, int facet) {
    if (complex.neighbors[cell][facet] < cell) {
      const int mirror = mirrorFacet (complex, cell, facet);
      cell = complex.neighbors[cell][facet];
      facet = mirror;
    }
    const auto position = std::lower_bound (others.begin (), others.end (), Facet{cell, facet});
    return position != others.end () && *position == Facet{cell, facet}
             ? static_cast<std::int32_t> (position - others.begin ())
             : -1;
  };

  DisjointSets sets (others.size ());
  std::vector<Patch> own (others.size ()); // of single triangles
  for (std::size_t i = 0; i < others.size (); ++i) {
    const std::array<std::int32_t, 3> triangle = facetOf (complex, others[i].cell, others[i].facet);
    for (int side = 0; side < 3; ++side) {
      int crossings = 0;
      std::int32_t other = -1;
      bool beside_surface = false;
      aroundEdge (complex, triangle[side], triangle[(side + 1) % 3], others[i].cell, others[i].facet,
                  [&] (std::int32_t cell, int facet) {
                    if (colors[cell] == colors[complex.neighbors[cell][facet]])
                      return;
                    ++crossings;
                    other = indexOf (cell, facet);
                    beside_surface = surface.contains (cell, facet);
                  });
      if (crossings != 1 || (other < 0 && !beside_surface))
        own[i].fills = false; // the surface crosses itself here, or reaches to infinity
      else if (other >= 0)
        sets.join (static_cast<std::uint32_t> (i), static_cast<std::uint32_t> (other));
      else
        ++own[i].border;
    }
  }

  std::vector<std::uint32_t> number;
  std::vector<Patch> patches (sets.number (number));
  for (std::size_t i = 0; i < others.size (); ++i) {
    Patch& patch = patches[number[i]];
    patch.facets.push_back (others[i]);
    patch.border += own[i].border;
    patch.fills = patch.fills && own[i].fills;
  }
  return patches;
}

} // namespace manifold
} // namespace pcl
