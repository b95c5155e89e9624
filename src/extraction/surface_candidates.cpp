#include "extraction/surface_candidates.h"

#include "extraction/facet_set.h"
#include "extraction/fan.h"
#include "voronoi/cocone.h"

#include <algorithm>

namespace pcl {
namespace manifold {

bool
SurfaceCandidates::contains (std::int32_t cell, int facet) const
{
  if (facets_ != nullptr)
    return facets_->contains (cell, facet);
  const DelaunayComplex& complex = *dimensions_.complex;
  const std::array<std::int32_t, 3> triangle = facetOf (complex, cell, facet);
  if (std::find (triangle.begin (), triangle.end (), DelaunayComplex::INFINITE_VERTEX) != triangle.end ())
    return false;
  const std::int32_t neighbor = complex.neighbors[cell][facet];
  return std::any_of (triangle.begin (), triangle.end (), [&] (std::int32_t sample) {
    return roles_[sample] == Role::SURFACE &&
           coconeMeetsEdge (VoronoiCell (complex, sample), dimensions_.normals.col (sample), cell, neighbor);
  });
}

bool
SurfaceCandidates::areManifoldAt (std::int32_t sample, const std::vector<std::uint8_t>& colors) const
{
  const DelaunayComplex& complex = *dimensions_.complex;
  Fan fan;
  VoronoiCell (complex, sample).forEachEdge ([&] (std::int32_t a, std::int32_t b, int facet) {
    if (colors[a] == colors[b] || !contains (a, facet))
      return;
    // As seen from the cells of colour 1: where the colour changes four times around an edge, two facets that
    // meet there may have these cells on different sides, and no surface with two sides has both.
    const std::array<std::int32_t, 2> side = oppositeSide (complex, a, facet, sample);
    fan.add (side[colors[a] == 1 ? 0 : 1], side[colors[a] == 1 ? 1 : 0]);
  });
  return fan.isManifold () && fan.isDirected ();
}

} // namespace manifold
} // namespace pcl
