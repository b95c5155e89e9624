#include "extraction/extract_shape.h"

#include "extraction/cell_coloring.h"
#include "extraction/color_repair.h"
#include "extraction/curves.h"
#include "extraction/one_sided.h"
#include "extraction/solids.h"
#include "extraction/surface_growth.h"
#include "extraction/surface_opening.h"

#include <algorithm>

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

// The skin of a solid is given by its tetrahedra: triangles beside them, or between samples of their skins
// only, are not a surface of their own.
void
eraseSkins (const SampleDimensions& dimensions, const std::vector<std::uint8_t>& solid, FacetSet& surface)
{
  const DelaunayComplex& complex = surface.complex ();
  if (std::find (solid.begin (), solid.end (), 1) == solid.end ())
    return;
  for (std::size_t i = 0; i < complex.cells.size (); ++i)
    for (int k = 0; k < 4; ++k) {
      const auto cell = static_cast<std::int32_t> (i);
      if (!surface.contains (cell, k))
        continue;
      const std::array<std::int32_t, 3> triangle = facetOf (complex, cell, k);
      if (solid[cell] || solid[complex.neighbors[i][k]] ||
          std::all_of (triangle.begin (), triangle.end (),
                       [&] (std::int32_t sample) { return dimensions.manifold_dimension[sample] == 3; }))
        surface.erase (cell, k);
    }
}

// The samples whose triangles erasing the skins may have split in several fans.
std::vector<std::int32_t>
samplesBesideSolids (const DelaunayComplex& complex, const std::vector<std::uint8_t>& solid)
{
  std::vector<std::int32_t> samples;
  for (std::size_t i = 0; i < solid.size (); ++i)
    if (solid[i])
      samples.insert (samples.end (), complex.cells[i].begin (), complex.cells[i].end ());
  std::sort (samples.begin (), samples.end ());
  samples.erase (std::unique (samples.begin (), samples.end ()), samples.end ());
  return samples;
}

} // namespace

SimplicialComplex
extractShape (const SampleDimensions& dimensions, bool watertight, StageLog& log)
{
  const DelaunayComplex& complex = *dimensions.complex;
  if (complex.affine_dimension < 2)
    return polyline (complex.line);

  if (!log.begin ("color cells", 0.7f))
    return {};
  const std::vector<Role> roles = sampleRoles (dimensions);
  std::vector<std::uint8_t> colors = colorCells (dimensions, roles, watertight);
  const std::vector<std::uint8_t> seams = findSeams (dimensions, roles, colors);

  if (!log.begin ("repair", 0.8f))
    return {};
  repairColors (dimensions, roles, watertight, colors);
  insertSamples (dimensions, roles, colors);

  if (!log.begin ("surfaces", 0.86f))
    return {};
  FacetSet surface = watertight ? closedSurface (complex, colors) : openSurface (dimensions, roles, colors);
  if (!watertight) {
    eraseOneSided (seams, surface);
    growSurface (dimensions, roles, surface);
    fillSmallLoops (surface);
  }

  if (!log.begin ("solids and curves", 0.92f))
    return {};
  const std::vector<std::uint8_t> solid = findSolids (dimensions, roles, colors);
  eraseSkins (dimensions, solid, surface);
  eraseToManifold (samplesBesideSolids (complex, solid), surface);

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
