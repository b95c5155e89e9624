#include "extraction/extract_shape.h"

#include "extraction/cell_coloring.h"
#include "extraction/color_changes.h"
#include "extraction/color_repair.h"
#include "extraction/curves.h"
#include "extraction/one_sided.h"
#include "extraction/outer_walk.h"
#include "extraction/solids.h"
#include "extraction/surface_growth.h"
#include "extraction/surface_opening.h"
#include "extraction/surface_pruning.h"

#include <algorithm>
#include <utility>

namespace pcl {
namespace manifold {

namespace {

// Samples on a line are one polyline.
SimplicialComplex
polyline (const std::vector<std::int32_t>& line)
{
  SimplicialComplex shape;
  for (std::size_t i = 0; i + 1 < line.size (); ++i)
    shape.edges.push_back ({line[i], line[i + 1]});
  return shape;
}

// The samples of solids, ascending.
std::vector<std::int32_t>
samplesOfSolids (const DelaunayComplex& complex, const std::vector<std::uint8_t>& solid)
{
  std::vector<std::int32_t> samples;
  for (std::size_t i = 0; i < solid.size (); ++i)
    if (solid[i])
      samples.insert (samples.end (), complex.cells[i].begin (), complex.cells[i].end ());
  std::sort (samples.begin (), samples.end ());
  samples.erase (std::unique (samples.begin (), samples.end ()), samples.end ());
  return samples;
}

// The skin of a solid is given by its tetrahedra: triangles beside them are no surface of their own. Nor are
// triangles between samples of solids only, but for those of a closed surface.
void
eraseSkins (const std::vector<std::uint8_t>& solid, bool watertight, FacetSet& surface)
{
  const DelaunayComplex& complex = surface.complex ();
  const std::vector<std::int32_t> samples = samplesOfSolids (complex, solid);
  if (samples.empty ())
    return;
  std::vector<std::uint8_t> of_solid (static_cast<std::size_t> (complex.samples->size ()), 0);
  for (const std::int32_t sample : samples)
    of_solid[sample] = 1;
  for (std::size_t i = 0; i < complex.cells.size (); ++i)
    for (int k = 0; k < 4; ++k) {
      const auto cell = static_cast<std::int32_t> (i);
      if (!surface.contains (cell, k))
        continue;
      const std::array<std::int32_t, 3> triangle = facetOf (complex, cell, k);
      if (solid[cell] || solid[complex.neighbors[i][k]] ||
          (!watertight && std::all_of (triangle.begin (), triangle.end (),
                                       [&] (std::int32_t sample) { return of_solid[sample] != 0; })))
        surface.erase (cell, k);
    }
  // Where a fan lost triangles in its middle it is two fans now.
  eraseToManifold (samples, surface);
}

// A cell goes over to the other colour where more of the changes of colour around it are candidates then, and
// fewer are not: most often a flat cell whose upper sides are candidates, or whose lower ones are.
void
settleOnCandidates (const DelaunayComplex& complex, const FacetFlags& facets,
                    std::vector<std::uint8_t>& colors)
{
  std::vector<std::int32_t> queue;
  for (std::int32_t cell = complex.finite_cells; cell-- > 0;)
    queue.push_back (cell);
  while (!queue.empty ()) {
    const std::int32_t cell = queue.back ();
    queue.pop_back ();
    int gain_candidates = 0;
    int gain_others = 0;
    for (int k = 0; k < 4; ++k) {
      const bool changes = colors[cell] != colors[complex.neighbors[cell][k]];
      (facets.contains (cell, k) ? gain_candidates : gain_others) += changes ? -1 : 1;
    }
    if (gain_candidates <= 0 || gain_others >= 0)
      continue;
    colors[cell] ^= 1;
    for (const std::int32_t neighbor : complex.neighbors[cell])
      if (!complex.isInfinite (neighbor))
        queue.push_back (neighbor);
  }
}

// Moves the changes of colour onto the candidates of another method as far as possible.
void
keepToCandidates (const DelaunayComplex& complex, const GivenCandidates& given,
                  std::vector<std::uint8_t>& colors)
{
  // Of samples in a plane every triangle has one side or the other: candidates alone decide.
  if (complex.affine_dimension == 2) {
    for (std::size_t cell = 0; cell < colors.size (); ++cell)
      colors[cell] =
        complex.centers.col (static_cast<Eigen::Index> (cell)).dot (complex.centers.col (0)) > 0.0;
    return;
  }
  std::vector<std::uint8_t> walked;
  if (given.proved && walkOutside (complex, given.facets, walked)) {
    colors = std::move (walked);
    return;
  }
  settleOnCandidates (complex, given.facets, colors);
  const std::vector<Facet> changes = colorChanges (complex, colors);
  const bool misses_many =
    10 * countMissed (complex, colors) > static_cast<std::size_t> (complex.samples->size ());
  if (!misses_many && std::all_of (changes.begin (), changes.end (), [&] (const Facet& facet) {
        return given.facets.contains (facet.cell, facet.facet);
      }))
    return;
  // Where the walk that the theory knows of encloses all samples, too, by as many triangles, both surfaces
  // have the same Euler characteristic, and that of the walk is made of candidates only. With more triangles
  // or fewer it has webs between parts, or fills handles, which the colours by poles have not.
  if (walkOutside (complex, given.facets, walked) &&
      (misses_many || colorChanges (complex, walked).size () == changes.size ()))
    colors = std::move (walked);
}

} // namespace

SimplicialComplex
extractShape (const SampleDimensions& dimensions, bool watertight, StageLog& log,
              const GivenCandidates* given)
{
  const DelaunayComplex& complex = *dimensions.complex;
  if (complex.affine_dimension < 2)
    return polyline (complex.line);

  if (!log.begin ("color cells", 0.7f))
    return {};
  const std::vector<Role> roles = sampleRoles (dimensions);
  const SurfaceCandidates candidates (dimensions, roles, given != nullptr ? &given->facets : nullptr);
  const SolidCells solid_cells = findSolidCells (dimensions, roles);
  const CellColors coloring = colorCells (dimensions, roles, solid_cells.certain, watertight);
  std::vector<std::uint8_t> colors = coloring.colors;
  if (given != nullptr)
    keepToCandidates (complex, *given, colors);

  if (!log.begin ("repair", 0.8f))
    return {};
  repairColors (candidates, watertight, colors);
  insertSamples (dimensions, roles, colors);

  if (!log.begin ("surfaces", 0.86f))
    return {};
  FacetSet surface = watertight ? closedSurface (complex, colors) : openSurface (candidates, colors);
  if (!watertight) {
    mendOneSided (candidates, solid_cells.certain, coloring.colors, coloring.torn, surface);
    growSurface (candidates, surface);
    fillSmallLoops (roles, surface);
  }

  if (!log.begin ("solids and curves", 0.92f))
    return {};
  const std::vector<std::uint8_t> solid = findSolids (dimensions, roles, solid_cells, colors, watertight);
  eraseSkins (solid, watertight, surface);

  SimplicialComplex shape;
  for (const auto& edge : extractCurves (dimensions, roles, surface, solid))
    shape.edges.push_back ({edge[0], edge[1]});
  if (!log.begin ("orientation", 0.96f))
    return {};
  for (const auto& triangle : surface.triangles ([&colors] (std::int32_t cell) { return colors[cell] == 1; }))
    shape.triangles.push_back ({triangle[0], triangle[1], triangle[2]});
  for (std::size_t i = 0; i < solid.size (); ++i)
    if (solid[i])
      shape.tetrahedra.push_back (complex.cells[i]);
  orientTriangles (shape.triangles, complex.samples->points);
  return shape;
}

} // namespace manifold
} // namespace pcl
