#include "extraction/solids.h"

#include "common/parallel.h"
#include "extraction/color_repair.h"
#include "voronoi/voronoi_cell.h"

#include <algorithm>
#include <limits>

namespace pcl {
namespace manifold {

namespace {

// A cell whose circumsphere is larger than this many times the distance to the fourth nearest sample spans a
// gap: the largest gaps between random samples of a solid stay below.
constexpr double MAX_RADIUS = 3.0;
constexpr double MIN_SOLID_SHARE = 0.5;

// The distance to the fourth nearest Delaunay neighbour.
double
localSpacing (const DelaunayComplex& complex, std::int32_t sample)
{
  constexpr std::size_t NEIGHBOR = 3;
  const VoronoiCell cell (complex, sample);
  std::vector<std::int32_t> neighbors;
  cell.visitNeighbors ([&neighbors] (std::int32_t q) { neighbors.push_back (q); });
  std::sort (neighbors.begin (), neighbors.end ());
  neighbors.erase (std::unique (neighbors.begin (), neighbors.end ()), neighbors.end ());
  std::vector<double> distances;
  for (const std::int32_t q : neighbors)
    distances.push_back (cell.relative (q).norm ());
  const std::size_t rank = std::min (NEIGHBOR, distances.size () - 1);
  std::nth_element (distances.begin (), distances.begin () + static_cast<std::ptrdiff_t> (rank),
                    distances.end ());
  return distances[rank];
}

// The cells of one colour around a seed that enter (cell) lets in.
template <typename Enter>
std::vector<std::int32_t>
floodRegion (const DelaunayComplex& complex, const std::vector<std::uint8_t>& colors, std::int32_t seed,
             const Enter& enter, std::vector<std::uint8_t>& seen)
{
  std::vector<std::int32_t> region (1, seed);
  seen[seed] = 1;
  for (std::size_t next = 0; next < region.size (); ++next) {
    const std::int32_t cell = region[next];
    for (const std::int32_t neighbor : complex.neighbors[cell])
      if (!seen[neighbor] && colors[neighbor] == colors[cell] && enter (neighbor)) {
        seen[neighbor] = 1;
        region.push_back (neighbor);
      }
  }
  return region;
}

// Whether a region is a solid: it has no outside, and most of it is between samples of solids. What merely
// encloses a few of them is not.
bool
isSolid (const DelaunayComplex& complex, const SolidCells& cells, const std::vector<std::int32_t>& region)
{
  const auto possible = std::count_if (region.begin (), region.end (),
                                       [&] (std::int32_t cell) { return cells.possible[cell] != 0; });
  return static_cast<double> (possible) >= MIN_SOLID_SHARE * static_cast<double> (region.size ()) &&
         std::none_of (region.begin (), region.end (),
                       [&] (std::int32_t cell) { return complex.isInfinite (cell); });
}

} // namespace

SolidCells
findSolidCells (const SampleDimensions& dimensions, const std::vector<Role>& roles)
{
  const DelaunayComplex& complex = *dimensions.complex;
  SolidCells cells;
  cells.certain.assign (complex.cells.size (), 0);
  cells.possible.assign (complex.cells.size (), 0);
  if (std::find (roles.begin (), roles.end (), Role::SOLID) == roles.end ())
    return cells;
  std::vector<double> spacing (roles.size (), 0.0);
  parallelFor (roles.size (), [&] (std::size_t i) {
    if (dimensions.manifold_dimension[i] == 3)
      spacing[i] = localSpacing (complex, static_cast<std::int32_t> (i));
  });
  parallelFor (static_cast<std::size_t> (complex.finite_cells), [&] (std::size_t i) {
    const DelaunayComplex::Cell& cell = complex.cells[i];
    const double radius = (complex.centers.col (i) - complex.samples->points.col (cell[0])).norm ();
    const auto of_solids =
      std::count_if (cell.begin (), cell.end (), [&] (std::int32_t v) { return spacing[v] > 0.0; });
    cells.certain[i] = of_solids == 4 && std::any_of (cell.begin (), cell.end (), [&] (std::int32_t vertex) {
                         return roles[vertex] == Role::SOLID && radius <= MAX_RADIUS * spacing[vertex];
                       });
    double largest = 0.0;
    double smallest = std::numeric_limits<double>::infinity ();
    for (const std::int32_t vertex : cell) {
      largest = std::max (largest, spacing[vertex]);
      smallest = std::min (smallest, spacing[vertex]);
    }
    cells.possible[i] = smallest > 0.0 && radius <= MAX_RADIUS * largest;
  });
  return cells;
}

std::vector<std::uint8_t>
findSolids (const SampleDimensions& dimensions, const std::vector<Role>& roles, const SolidCells& cells,
            const std::vector<std::uint8_t>& colors, bool closed)
{
  const DelaunayComplex& complex = *dimensions.complex;
  std::vector<std::uint8_t> solid (complex.cells.size (), 0);
  if (std::find (cells.certain.begin (), cells.certain.end (), 1) == cells.certain.end ())
    return solid;
  std::vector<std::uint8_t> seen (complex.cells.size (), 0);
  const auto enter = [&] (std::int32_t cell) { return closed || cells.possible[cell]; };
  for (std::int32_t cell = 0; cell < complex.finite_cells; ++cell)
    if (cells.certain[cell] && !seen[cell]) {
      const std::vector<std::int32_t> region = floodRegion (complex, colors, cell, enter, seen);
      if (isSolid (complex, cells, region))
        for (const std::int32_t inside : region)
          solid[inside] = 1;
    }
  repairColors ({dimensions, roles}, true, solid);
  return solid;
}

} // namespace manifold
} // namespace pcl
