#include "extraction/candidates.h"

#include "extraction/facet_set.h"
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
