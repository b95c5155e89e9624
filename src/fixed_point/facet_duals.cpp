#include "fixed_point/facet_duals.h"

namespace pcl {
namespace manifold {

Piece
cornersOf (const DelaunayComplex& complex, const Facet& facet)
{
  const std::array<std::int32_t, 3> samples = facetOf (complex, facet.cell, facet.facet);
  const Eigen::Matrix3Xd& points = complex.samples->points;
  return {points.col (samples[0]), points.col (samples[1]), points.col (samples[2])};
}

DualEdge
dualEdge (const DelaunayComplex& complex, const Facet& facet)
{
  DualEdge edge{cornersOf (complex, facet), {}, 0};
  const std::int32_t neighbor = complex.neighbors[facet.cell][facet.facet];
  for (const std::int32_t opposite :
       {complex.cells[facet.cell][facet.facet],
        complex.cells[neighbor][mirrorFacet (complex, facet.cell, facet.facet)]})
    if (opposite != DelaunayComplex::INFINITE_VERTEX)
      edge.opposite[edge.bounds++] = complex.samples->points.col (opposite);
  return edge;
}

} // namespace manifold
} // namespace pcl
