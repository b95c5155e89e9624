#include "extraction/one_sided.h"

#include "complex/disjoint_sets.h"
#include "extraction/candidates.h"

#include <algorithm>
#include <cmath>

namespace pcl {
namespace manifold {

namespace {

// A change of colour in free space crosses a one-sided component of n samples from rim to rim, so that it
// meets in the order of sqrt (n) of them. In noise there are a few.
constexpr std::size_t MIN_SAMPLES = 24;
constexpr double MIN_SHARE_OF_ROOT = 0.5;

} // namespace

std::vector<std::uint8_t>
findSeams (const SampleDimensions& dimensions, const std::vector<Role>& roles, const std::vector<Facet>& torn)
{
  const DelaunayComplex& complex = *dimensions.complex;
  std::vector<std::uint8_t> samples (roles.size (), 0);
  for (const Facet& facet : torn)
    if (!complex.isInfinite (complex.neighbors[facet.cell][facet.facet]) &&
        !isCandidate (dimensions, roles, facet.cell, facet.facet))
      for (const std::int32_t vertex : facetOf (complex, facet.cell, facet.facet))
        samples[vertex] = 1;
  return samples;
}

std::size_t
eraseOneSided (const std::vector<std::uint8_t>& seams, FacetSet& surface)
{
  if (static_cast<std::size_t> (std::count (seams.begin (), seams.end (), 1)) < MIN_SAMPLES)
    return 0;
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
  std::size_t erased = 0;
  for (std::size_t i = 0; i < seams.size (); ++i) {
    const std::uint32_t c = component[i];
    if (crossed[c] < MIN_SAMPLES ||
        static_cast<double> (crossed[c]) < MIN_SHARE_OF_ROOT * std::sqrt (static_cast<double> (sizes[c])))
      continue;
    ++erased;
    std::vector<Facet> facets;
    surface.forEachAt (static_cast<std::int32_t> (i), [&] (std::int32_t cell, int facet) {
      facets.push_back ({cell, facet});
    });
    for (const Facet& facet : facets)
      surface.erase (facet.cell, facet.facet);
  }
  return erased;
}

} // namespace manifold
} // namespace pcl
