#include "extraction/one_sided.h"

#include "complex/disjoint_sets.h"
#include "extraction/cell_coloring.h"
#include "extraction/color_repair.h"
#include "extraction/surface_opening.h"
#include "extraction/surface_pruning.h"
#include "voronoi/nearest_samples.h"

#include <algorithm>
#include <cmath>

namespace pcl {
namespace manifold {

namespace {

// A change of colour in free space crosses a one-sided component of n samples from rim to rim, so that it
// meets in the order of sqrt (n) of them. In noise there are a few.
constexpr std::size_t MIN_SAMPLES = 24;
constexpr double MIN_SHARE_OF_ROOT = 0.5;
// How far around a tear the surface is replaced, and how far the new colours keep away from it, in steps to
// the nearest samples.
constexpr int REPLACED_STEPS = 4;
constexpr int AVOIDED_STEPS = 8;
constexpr int NEIGHBORS = 10;

// Flags the samples of the triangles across which the colour changes in free space and which are no
// candidates.
std::vector<std::uint8_t>
findSeams (const SurfaceCandidates& candidates, const std::vector<Facet>& torn)
{
  const DelaunayComplex& complex = candidates.complex ();
  std::vector<std::uint8_t> samples (candidates.roles ().size (), 0);
  for (const Facet& facet : torn)
    if (!complex.isInfinite (complex.neighbors[facet.cell][facet.facet]) &&
        !candidates.contains (facet.cell, facet.facet))
      for (const std::int32_t vertex : facetOf (complex, facet.cell, facet.facet))
        samples[vertex] = 1;
  return samples;
}

// Flags the samples of the components of a surface that such a seam crosses.
std::vector<std::uint8_t>
oneSidedSamples (const std::vector<std::uint8_t>& seams, const FacetSet& surface)
{
  std::vector<std::uint8_t> samples (seams.size (), 0);
  if (static_cast<std::size_t> (std::count (seams.begin (), seams.end (), 1)) < MIN_SAMPLES)
    return samples;
  DisjointSets sets (seams.size ());
  for (const auto& triangle : surface.triangles ([] (std::int32_t) { return false; })) {
    sets.join (static_cast<std::uint32_t> (triangle[0]), static_cast<std::uint32_t> (triangle[1]));
    sets.join (static_cast<std::uint32_t> (triangle[0]), static_cast<std::uint32_t> (triangle[2]));
  }
  std::vector<std::uint32_t> component;
  const std::uint32_t components = sets.number (component);
  std::vector<std::size_t> sizes (components, 0);
  std::vector<std::size_t> crossed (components, 0);
  for (std::size_t i = 0; i < seams.size (); ++i) {
    ++sizes[component[i]];
    crossed[component[i]] += seams[i];
  }
  for (std::size_t i = 0; i < seams.size (); ++i) {
    const std::uint32_t c = component[i];
    samples[i] =
      crossed[c] >= MIN_SAMPLES &&
      static_cast<double> (crossed[c]) >= MIN_SHARE_OF_ROOT * std::sqrt (static_cast<double> (sizes[c]));
  }
  return samples;
}

// The flagged samples and, so many steps on, the nearest ones around them.
std::vector<std::uint8_t>
grown (const DelaunayComplex& complex, std::vector<std::uint8_t> samples, int steps)
{
  NearestSamples nearest (complex);
  for (int step = 0; step < steps; ++step) {
    const std::vector<std::uint8_t> before = samples;
    for (std::size_t i = 0; i < before.size (); ++i)
      if (before[i])
        for (const std::int32_t q : nearest.find (static_cast<std::int32_t> (i), NEIGHBORS))
          samples[q] = 1;
  }
  return samples;
}

// The cells at the flagged samples.
std::vector<std::uint8_t>
cellsAt (const DelaunayComplex& complex, const std::vector<std::uint8_t>& samples)
{
  std::vector<std::uint8_t> cells (complex.cells.size (), 0);
  for (std::size_t i = 0; i < samples.size (); ++i)
    if (samples[i])
      for (const std::int32_t cell : VoronoiCell (complex, static_cast<std::int32_t> (i)))
        cells[cell] = 1;
  return cells;
}

std::vector<Facet>
facetsAt (const FacetSet& surface, std::int32_t sample)
{
  std::vector<Facet> facets;
  surface.forEachAt (sample, [&facets] (std::int32_t cell, int facet) { facets.push_back ({cell, facet}); });
  return facets;
}

} // namespace

std::size_t
mendOneSided (const SurfaceCandidates& candidates, const std::vector<std::uint8_t>& solid,
              const std::vector<std::uint8_t>& colors, const std::vector<Facet>& torn, FacetSet& surface)
{
  const DelaunayComplex& complex = candidates.complex ();
  std::vector<std::uint8_t> tear = oneSidedSamples (findSeams (candidates, torn), surface);
  if (std::find (tear.begin (), tear.end (), 1) == tear.end ())
    return 0;
  for (std::size_t i = 0; i < tear.size (); ++i)
    tear[i] = tear[i] && crossesItself (complex, colors, static_cast<std::int32_t> (i)) ? 1 : 0;

  const std::vector<std::uint8_t> avoided = cellsAt (complex, grown (complex, tear, AVOIDED_STEPS));
  std::vector<std::uint8_t> other_colors =
    colorCells (candidates.dimensions (), candidates.roles (), solid, false, avoided).colors;
  repairColors (candidates, false, other_colors);
  insertSamples (candidates.dimensions (), candidates.roles (), other_colors);
  const FacetSet other = openSurface (candidates, other_colors);

  const std::vector<std::uint8_t> replaced = grown (complex, tear, REPLACED_STEPS);
  std::vector<std::int32_t> changed;
  const auto forReplaced = [&] (const FacetSet& from, const auto& change) {
    for (std::size_t i = 0; i < replaced.size (); ++i)
      if (replaced[i])
        for (const Facet& facet : facetsAt (from, static_cast<std::int32_t> (i))) {
          change (facet);
          for (const std::int32_t vertex : facetOf (complex, facet.cell, facet.facet))
            changed.push_back (vertex);
        }
  };
  forReplaced (surface, [&] (const Facet& facet) { surface.erase (facet.cell, facet.facet); });
  forReplaced (other, [&] (const Facet& facet) { surface.insert (facet.cell, facet.facet); });
  std::sort (changed.begin (), changed.end ());
  changed.erase (std::unique (changed.begin (), changed.end ()), changed.end ());
  eraseToManifold (changed, surface);
  return static_cast<std::size_t> (std::count (replaced.begin (), replaced.end (), 1));
}

} // namespace manifold
} // namespace pcl
