#include "extraction/facet_fitting.h"

#include "extraction/surface_pruning.h"
#include "extraction/triangle_shape.h"

#include <algorithm>
#include <utility>

namespace pcl {
namespace manifold {

namespace {

// Triangles that meet at a sharper edge than 60 degrees are taken for folded.
constexpr double FOLDED = 0.5;

// Smallest circumcircle first, each triangle once.
void
sortBySize (const DelaunayComplex& complex, std::vector<Facet>& facets)
{
  std::vector<std::pair<double, Facet>> ranked;
  ranked.reserve (facets.size ());
  for (const Facet& facet : facets)
    ranked.emplace_back (squaredCircumradius (complex, facet.cell, facet.facet), facet);
  std::sort (ranked.begin (), ranked.end ());
  ranked.erase (std::unique (ranked.begin (), ranked.end ()), ranked.end ());
  facets.clear ();
  for (const auto& facet : ranked)
    facets.push_back (facet.second);
}

// Whether the triangle (v, a, b) may join the triangles at v.
bool
fits (const FacetSet& surface, std::int32_t v, std::int32_t a, std::int32_t b, Fan& fan)
{
  fan.clear ();
  bool folded = false;
  surface.forEachAt (v, [&] (std::int32_t cell, int facet) {
    const std::array<std::int32_t, 2> side = oppositeSide (surface.complex (), cell, facet, v);
    fan.add (side[0], side[1]);
    for (int k = 0; k < 2; ++k)
      folded |= (side[k] == a && dihedralCosine (surface.complex (), v, a, b, side[1 - k]) > FOLDED) ||
                (side[k] == b && dihedralCosine (surface.complex (), v, b, a, side[1 - k]) > FOLDED);
  });
  fan.add (a, b);
  return !folded && fan.canBecomeManifold ();
}

} // namespace

void
insertFitting (std::vector<Facet> candidates, FacetSet& surface)
{
  sortBySize (surface.complex (), candidates);
  Fan fan;
  std::vector<std::int32_t> changed;
  const auto tryInsert = [&] (const Facet& candidate) {
    const std::array<std::int32_t, 3> triangle =
      facetOf (surface.complex (), candidate.cell, candidate.facet);
    for (int k = 0; k < 3; ++k)
      if (!fits (surface, triangle[k], triangle[(k + 1) % 3], triangle[(k + 2) % 3], fan))
        return false;
    surface.insert (candidate.cell, candidate.facet);
    changed.insert (changed.end (), triangle.begin (), triangle.end ());
    return true;
  };
  for (std::size_t before = candidates.size () + 1; candidates.size () < before;) {
    before = candidates.size ();
    candidates.erase (std::remove_if (candidates.begin (), candidates.end (), tryInsert), candidates.end ());
  }
  std::sort (changed.begin (), changed.end ());
  changed.erase (std::unique (changed.begin (), changed.end ()), changed.end ());
  eraseToManifold (changed, surface);
}

} // namespace manifold
} // namespace pcl
