#include "extraction/surface_growth.h"

#include "complex/disjoint_sets.h"
#include "extraction/candidates.h"
#include "extraction/facet_fitting.h"

#include <algorithm>

namespace pcl {
namespace manifold {

namespace {

// Fewer samples without a triangle than this, next to each other, are noise beside a surface; more of them
// are a sheet that has no two sides.
constexpr std::uint32_t MIN_CLUSTER = 100;
// Longer loops than this are kept as the boundary of something.
constexpr std::size_t MAX_FILLED_LOOP = 6;

} // namespace

void
growSurface (const SampleDimensions& dimensions, const std::vector<Role>& roles, FacetSet& surface)
{
  const DelaunayComplex& complex = surface.complex ();
  const std::vector<std::uint8_t> coverage = surface.coverage ();
  const auto isUncovered = [&] (std::int32_t sample) {
    return roles[sample] == Role::SURFACE && (coverage[sample] & FacetSet::COVERED) == 0;
  };
  std::vector<std::vector<Facet>> candidates_of (roles.size ());
  DisjointSets clusters (roles.size ());
  for (std::size_t i = 0; i < roles.size (); ++i) {
    const auto sample = static_cast<std::int32_t> (i);
    if (!isUncovered (sample))
      continue;
    VoronoiCell (complex, sample).forEachEdge ([&] (std::int32_t cell, std::int32_t, int facet) {
      if (!isCandidate (dimensions, roles, cell, facet))
        return;
      candidates_of[i].push_back ({cell, facet});
      for (const std::int32_t vertex : oppositeSide (complex, cell, facet, sample))
        if (isUncovered (vertex))
          clusters.join (static_cast<std::uint32_t> (sample), static_cast<std::uint32_t> (vertex));
    });
  }
  std::vector<std::uint32_t> sizes (roles.size (), 0);
  for (std::uint32_t i = 0; i < roles.size (); ++i)
    ++sizes[clusters.find (i)];
  std::vector<Facet> candidates;
  for (std::uint32_t i = 0; i < roles.size (); ++i)
    if (sizes[clusters.find (i)] >= MIN_CLUSTER)
      candidates.insert (candidates.end (), candidates_of[i].begin (), candidates_of[i].end ());
  insertFitting (std::move (candidates), surface);
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
fillSmallLoops (FacetSet& surface)
{
  const DelaunayComplex& complex = surface.complex ();
  std::vector<Facet> candidates;
  for (std::vector<std::int32_t>& loop : boundaryLoops (surface)) {
    if (loop.size () > MAX_FILLED_LOOP)
      continue;
    std::sort (loop.begin (), loop.end ());
    const auto onLoop = [&loop] (std::int32_t vertex) {
      return std::binary_search (loop.begin (), loop.end (), vertex);
    };
    for (const std::int32_t sample : loop)
      VoronoiCell (complex, sample).forEachEdge ([&] (std::int32_t cell, std::int32_t, int facet) {
        const std::array<std::int32_t, 2> side = oppositeSide (complex, cell, facet, sample);
        if (onLoop (side[0]) && onLoop (side[1]) && !surface.contains (cell, facet))
          candidates.push_back ({cell, facet});
      });
  }
  insertFitting (std::move (candidates), surface);
}

} // namespace manifold
} // namespace pcl
