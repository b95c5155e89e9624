#include "extraction/color_changes.h"

#include "common/parallel.h"
#include "voronoi/voronoi_cell.h"

#include <algorithm>

namespace pcl {
namespace manifold {

std::vector<Facet>
colorChanges (const DelaunayComplex& complex, const std::vector<std::uint8_t>& colors)
{
  // Blocks of a fixed size, so that the order does not depend on the number of threads.
  constexpr std::size_t BLOCK = 1 << 15;
  const std::size_t cells = complex.cells.size ();
  std::vector<std::vector<Facet>> blocks (cells / BLOCK + 1);
  parallelFor (
    blocks.size (),
    [&] (std::size_t block) {
      const std::size_t end = std::min (cells, (block + 1) * BLOCK);
      for (std::size_t i = block * BLOCK; i < end; ++i)
        for (int k = 0; k < 4; ++k) {
          const auto cell = static_cast<std::int32_t> (i);
          const std::int32_t neighbor = complex.neighbors[i][k];
          if (cell < neighbor && colors[i] != colors[neighbor])
            blocks[block].push_back ({cell, k});
        }
    },
    1);
  std::vector<Facet> changes;
  for (const std::vector<Facet>& block : blocks)
    changes.insert (changes.end (), block.begin (), block.end ());
  return changes;
}

std::size_t
countMissed (const DelaunayComplex& complex, const std::vector<std::uint8_t>& colors)
{
  std::vector<std::uint8_t> missed (static_cast<std::size_t> (complex.samples->size ()));
  parallelFor (missed.size (), [&] (std::size_t i) {
    const VoronoiCell star (complex, static_cast<std::int32_t> (i));
    missed[i] = std::all_of (star.begin (), star.end (),
                             [&] (std::int32_t cell) { return colors[cell] == colors[*star.begin ()]; });
  });
  return static_cast<std::size_t> (std::count (missed.begin (), missed.end (), 1));
}

bool
hasInfiniteVertex (const DelaunayComplex& complex, const Facet& facet)
{
  // Only infinite cells have it, as their last vertex.
  return complex.isInfinite (facet.cell) && facet.facet != 3;
}

} // namespace manifold
} // namespace pcl
