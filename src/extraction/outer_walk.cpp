#include "extraction/outer_walk.h"

#include "common/large_pages.h"
#include "extraction/color_changes.h"

namespace pcl {
namespace manifold {

bool
walkOutside (const DelaunayComplex& complex, const FacetFlags& facets, std::vector<std::uint8_t>& colors)
{
  assignLarge (colors, complex.cells.size (), std::uint8_t (1));
  std::vector<std::int32_t> stack;
  const auto reach = [&] (std::int32_t cell) {
    if (colors[cell] == 0)
      return;
    colors[cell] = 0;
    stack.push_back (cell);
  };
  // All infinite cells are one outside.
  for (std::size_t i = static_cast<std::size_t> (complex.finite_cells); i < complex.cells.size (); ++i)
    reach (static_cast<std::int32_t> (i));
  while (!stack.empty ()) {
    const std::int32_t cell = stack.back ();
    stack.pop_back ();
    for (int k = 0; k < 4; ++k)
      if (!facets.contains (cell, k))
        reach (complex.neighbors[cell][k]);
  }
  return countMissed (complex, colors) == 0;
}

} // namespace manifold
} // namespace pcl
