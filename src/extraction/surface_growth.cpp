#include "extraction/surface_growth.h"

#include "complex/disjoint_sets.h"
#include "extraction/facet_fitting.h"
#include "extraction/surface_pruning.h"

#include <algorithm>

namespace pcl {
namespace manifold {

namespace {

// Fewer samples without a triangle than this, next to each other, are noise beside a surface.
constexpr std::uint32_t MIN_CLUSTER = 100;
constexpr int MAX_ROUNDS = 6;
// Loops are filled if they have no more edges than this ...
constexpr std::size_t MAX_FILLED_LOOP = 12;
// ... or than this, where most of their samples are not on a rim: those are cracks between parts that grew
// together.
constexpr std::size_t MAX_FILLED_CRACK = 60;

// The surface samples without a triangle that are together with many others, ascending.
std::vector<std::int32_t>
uncoveredClusters (const SurfaceCandidates& candidates, const FacetSet& surface)
{
  const std::vector<Role>& roles = candidates.roles ();
  const DelaunayComplex& complex = surface.complex ();
  const std::vector<std::uint8_t> coverage = surface.coverage ();
  std::vector<std::int32_t> uncovered;
  for (std::size_t i = 0; i < roles.size (); ++i)
    if (roles[i] == Role::SURFACE && (coverage[i] & FacetSet::COVERED) == 0)
      uncovered.push_back (static_cast<std::int32_t> (i));
  DisjointSets clusters (roles.size ());
  for (const std::int32_t sample : uncovered)
    VoronoiCell (complex, sample).forEachEdge ([&] (std::int32_t cell, std::int32_t, int facet) {
      if (!candidates.contains (cell, facet))
        return;
      for (const std::int32_t vertex : oppositeSide (complex, cell, facet, sample))
        if (std::binary_search (uncovered.begin (), uncovered.end (), vertex))
          clusters.join (static_cast<std::uint32_t> (sample), static_cast<std::uint32_t> (vertex));
    });
  std::vector<std::uint32_t> sizes (roles.size (), 0);
  for (const std::int32_t sample : uncovered)
    ++sizes[clusters.find (static_cast<std::uint32_t> (sample))];
  uncovered.erase (std::remove_if (uncovered.begin (), uncovered.end (),
                                   [&] (std::int32_t sample) {
                                     return sizes[clusters.find (static_cast<std::uint32_t> (sample))] <
                                            MIN_CLUSTER;
                                   }),
                   uncovered.end ());
  return uncovered;
}

std::vector<std::int32_t>
samplesOf (const DelaunayComplex& complex, const std::vector<Facet>& facets)
{
  std::vector<std::int32_t> samples;
  for (const Facet& facet : facets)
    for (const std::int32_t vertex : facetOf (complex, facet.cell, facet.facet))
      samples.push_back (vertex);
  std::sort (samples.begin (), samples.end ());
  samples.erase (std::unique (samples.begin (), samples.end ()), samples.end ());
  return samples;
}

} // namespace

void
growSurface (const SurfaceCandidates& candidates, FacetSet& surface)
{
  const std::vector<std::int32_t> samples = uncoveredClusters (candidates, surface);
  if (samples.empty ())
    return;
  // Where fans did not meet all but one were erased: there is room for others then.
  std::vector<std::uint8_t> before;
  for (int round = 0; round < MAX_ROUNDS; ++round) {
    const std::vector<std::uint8_t> coverage = surface.coverage ();
    if (coverage == before)
      break;
    std::vector<Facet> fitting;
    for (const std::int32_t sample : samples)
      if (coverage[sample] != FacetSet::COVERED)
        VoronoiCell (surface.complex (), sample)
          .forEachEdge ([&] (std::int32_t cell, std::int32_t, int facet) {
            if (!surface.contains (cell, facet) && candidates.contains (cell, facet))
              fitting.push_back ({cell, facet});
          });
    insertFitting (std::move (fitting), surface);
    before = coverage;
  }
}

std::vector<std::vector<std::int32_t>>
boundaryLoops (const FacetSet& surface)
{
  const std::vector<std::uint8_t> coverage = surface.coverage ();
  const std::size_t samples = coverage.size ();
  std::vector<std::array<std::int32_t, 2>> next (samples, {-1, -1});
  Fan fan;
  for (std::size_t i = 0; i < samples; ++i)
    if (coverage[i] & FacetSet::OPEN) {
      surface.fanAt (static_cast<std::int32_t> (i), fan);
      next[i] = fan.ends ();
    }
  std::vector<std::vector<std::int32_t>> loops;
  std::vector<std::uint8_t> seen (samples, 0);
  for (std::size_t start = 0; start < samples; ++start) {
    if (next[start][0] < 0 || seen[start])
      continue;
    loops.emplace_back ();
    for (auto sample = static_cast<std::int32_t> (start); sample >= 0;) {
      seen[sample] = 1;
      loops.back ().push_back (sample);
      const std::array<std::int32_t, 2> ends = next[sample];
      sample = !seen[ends[0]] ? ends[0] : (!seen[ends[1]] ? ends[1] : -1);
    }
  }
  return loops;
}

void
fillSmallLoops (const std::vector<Role>& roles, FacetSet& surface)
{
  const DelaunayComplex& complex = surface.complex ();
  for (std::vector<std::int32_t>& loop : boundaryLoops (surface)) {
    const auto inside = std::count_if (loop.begin (), loop.end (),
                                       [&] (std::int32_t sample) { return roles[sample] == Role::SURFACE; });
    const bool crack = 2 * static_cast<std::size_t> (inside) > loop.size ();
    if (loop.size () > (crack ? MAX_FILLED_CRACK : MAX_FILLED_LOOP))
      continue;
    std::sort (loop.begin (), loop.end ());
    const auto onLoop = [&loop] (std::int32_t vertex) {
      return std::binary_search (loop.begin (), loop.end (), vertex);
    };
    std::vector<Facet> candidates;
    std::vector<Facet> before;
    for (const std::int32_t sample : loop)
      VoronoiCell (complex, sample).forEachEdge ([&] (std::int32_t cell, std::int32_t, int facet) {
        const std::array<std::int32_t, 2> side = oppositeSide (complex, cell, facet, sample);
        if (surface.contains (cell, facet))
          before.push_back ({cell, facet});
        else if (onLoop (side[0]) && onLoop (side[1]))
          candidates.push_back ({cell, facet});
      });
    insertFitting (candidates, surface);
    Fan fan;
    const bool filled = std::all_of (loop.begin (), loop.end (), [&] (std::int32_t sample) {
      surface.fanAt (sample, fan);
      return fan.isClosed ();
    });
    if (filled)
      continue;
    // A loop that is not filled as a whole is left as it was, not cut into smaller ones.
    for (const Facet& facet : candidates)
      surface.erase (facet.cell, facet.facet);
    for (const Facet& facet : before)
      surface.insert (facet.cell, facet.facet);
    eraseToManifold (samplesOf (complex, before), surface);
  }
}

} // namespace manifold
} // namespace pcl
