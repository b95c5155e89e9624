#include "extraction/cell_star.h"

#include "voronoi/voronoi_cell.h"

#include <algorithm>

namespace pcl {
namespace manifold {

void
CellStar::split (std::int32_t sample, const std::vector<std::uint8_t>& colors)
{
  const VoronoiCell star (complex_, sample);
  cells_.assign (star.begin (), star.end ());
  component_.assign (cells_.size (), -1);
  sizes_.clear ();
  infinite_.clear ();
  for (std::size_t seed = 0; seed < cells_.size (); ++seed) {
    if (component_[seed] >= 0)
      continue;
    const int component = components ();
    sizes_.push_back (0);
    infinite_.push_back (0);
    component_[seed] = component;
    stack_.assign (1, static_cast<int> (seed));
    while (!stack_.empty ()) {
      const std::int32_t cell = cells_[stack_.back ()];
      stack_.pop_back ();
      ++sizes_.back ();
      infinite_.back () |= complex_.isInfinite (cell) ? 1 : 0;
      for (int k = 0; k < 4; ++k) {
        const std::int32_t neighbor = complex_.neighbors[cell][k];
        if (complex_.cells[cell][k] == sample || colors[neighbor] != colors[cell])
          continue;
        const auto position = std::lower_bound (cells_.begin (), cells_.end (), neighbor) - cells_.begin ();
        if (component_[position] < 0) {
          component_[position] = component;
          stack_.push_back (static_cast<int> (position));
        }
      }
    }
  }
}

int
CellStar::smallest (bool finite) const
{
  int best = 0;
  const auto isBetter = [&] (int component) {
    if (finite && infinite_[component] != infinite_[best])
      return infinite_[component] < infinite_[best];
    return sizes_[component] < sizes_[best];
  };
  for (int component = 1; component < components (); ++component)
    if (isBetter (component))
      best = component;
  return best;
}

std::vector<std::int32_t>
CellStar::cellsOf (int component) const
{
  std::vector<std::int32_t> cells;
  for (std::size_t i = 0; i < cells_.size (); ++i)
    if (component_[i] == component)
      cells.push_back (cells_[i]);
  return cells;
}

} // namespace manifold
} // namespace pcl
