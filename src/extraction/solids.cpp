#include "extraction/solids.h"

#include "extraction/color_repair.h"
#include "voronoi/voronoi_cell.h"

#include <algorithm>

namespace pcl {
namespace manifold {

namespace {

// Flags a region of one colour; clears the flags again if it reaches an infinite cell.
void
floodRegion (const DelaunayComplex& complex, const std::vector<std::uint8_t>& colors, std::int32_t seed,
             std::vector<std::uint8_t>& seen, std::vector<std::uint8_t>& solid)
{
  std::vector<std::int32_t> region (1, seed);
  bool outside = false;
  seen[seed] = 1;
  for (std::size_t next = 0; next < region.size (); ++next) {
    const std::int32_t cell = region[next];
    outside = outside || complex.isInfinite (cell);
    for (const std::int32_t neighbor : complex.neighbors[cell])
      if (!seen[neighbor] && colors[neighbor] == colors[cell]) {
        seen[neighbor] = 1;
        region.push_back (neighbor);
      }
  }
  if (!outside)
    for (const std::int32_t cell : region)
      solid[cell] = 1;
}

} // namespace

std::vector<std::uint8_t>
findSolids (const SampleDimensions& dimensions, const std::vector<Role>& roles,
            const std::vector<std::uint8_t>& colors)
{
  const DelaunayComplex& complex = *dimensions.complex;
  std::vector<std::uint8_t> solid (complex.cells.size (), 0);
  if (std::find (roles.begin (), roles.end (), Role::SOLID) == roles.end ())
    return solid;
  std::vector<std::uint8_t> seen (complex.cells.size (), 0);
  for (std::size_t i = 0; i < roles.size (); ++i) {
    if (roles[i] != Role::SOLID)
      continue;
    for (const std::int32_t cell : VoronoiCell (complex, static_cast<std::int32_t> (i))) {
      if (complex.isInfinite (cell))
        continue;
      if (!seen[cell])
        floodRegion (complex, colors, cell, seen, solid);
      solid[cell] = 1;
    }
  }
  repairColors (dimensions, roles, true, solid);
  return solid;
}

} // namespace manifold
} // namespace pcl
