#include "extraction/candidates.h"

#include "extraction/facet_set.h"
#include "extraction/fan.h"
#include "voronoi/cocone.h"

#include <algorithm>

namespace pcl {
namespace manifold {

namespace {

// Sorts the samples of every simplex and keeps each once.
template <typename Simplex>
void
makeUnique (std::vector<Simplex>& simplices)
{
  for (Simplex& simplex : simplices)
    std::sort (simplex.begin (), simplex.end ());
  std::sort (simplices.begin (), simplices.end ());
  simplices.erase (std::unique (simplices.begin (), simplices.end ()), simplices.end ());
}

// The candidates of one sample of dimension k.
void
collectAt (const SampleDimensions& dimensions, std::int32_t sample, int k, SimplicialComplex& candidates)
{
  const DelaunayComplex& complex = *dimensions.complex;
  const VoronoiCell cell (complex, sample);
  if (k == 1) {
    for (const std::int32_t q : coconeNeighbors (complex, cell, dimensions.tangents.col (sample)))
      candidates.edges.push_back ({sample, q});
  } else if (k == 2) {
    const Eigen::Vector3d normal = dimensions.normals.col (sample);
    cell.forEachEdge ([&] (std::int32_t a, std::int32_t b, int facet) {
      if (coconeMeetsEdge (cell, normal, a, b))
        candidates.triangles.push_back (facetOf (complex, a, facet));
    });
  } else {
    for (const std::int32_t vertex : cell)
      if (!complex.isInfinite (vertex))
        candidates.tetrahedra.push_back (complex.cells[vertex]);
  }
}

} // namespace

bool
isCandidate (const SampleDimensions& dimensions, const std::vector<Role>& roles, std::int32_t cell, int facet)
{
  const DelaunayComplex& complex = *dimensions.complex;
  const std::array<std::int32_t, 3> triangle = facetOf (complex, cell, facet);
  if (std::find (triangle.begin (), triangle.end (), DelaunayComplex::INFINITE_VERTEX) != triangle.end ())
    return false;
  const std::int32_t neighbor = complex.neighbors[cell][facet];
  return std::any_of (triangle.begin (), triangle.end (), [&] (std::int32_t sample) {
    return roles[sample] == Role::SURFACE &&
           coconeMeetsEdge (VoronoiCell (complex, sample), dimensions.normals.col (sample), cell, neighbor);
  });
}

bool
candidatesAreManifold (const SampleDimensions& dimensions, const std::vector<Role>& roles,
                       const std::vector<std::uint8_t>& colors, std::int32_t sample)
{
  const DelaunayComplex& complex = *dimensions.complex;
  Fan fan;
  VoronoiCell (complex, sample).forEachEdge ([&] (std::int32_t a, std::int32_t b, int facet) {
    if (colors[a] == colors[b] || !isCandidate (dimensions, roles, a, facet))
      return;
    const std::array<std::int32_t, 2> side = oppositeSide (complex, a, facet, sample);
    fan.add (side[0], side[1]);
  });
  return fan.isManifold ();
}

SimplicialComplex
collectCandidates (const SampleDimensions& dimensions)
{
  SimplicialComplex candidates;
  const DelaunayComplex& complex = *dimensions.complex;
  if (complex.affine_dimension < 2) {
    for (std::size_t i = 0; i + 1 < complex.line.size (); ++i)
      candidates.edges.push_back ({complex.line[i], complex.line[i + 1]});
  } else {
    for (std::int32_t sample = 0; sample < complex.samples->size (); ++sample)
      collectAt (dimensions, sample, dimensions.dimension[sample], candidates);
  }
  makeUnique (candidates.edges);
  makeUnique (candidates.triangles);
  makeUnique (candidates.tetrahedra);
  return candidates;
}

} // namespace manifold
} // namespace pcl
