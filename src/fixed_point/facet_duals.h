#pragma once

#include "extraction/facet_set.h"
#include "fixed_point/dual_edge.h"

namespace pcl {
namespace manifold {

/** The corners of a Delaunay triangle, which has no infinite vertex. */
Piece cornersOf (const DelaunayComplex& complex, const Facet& facet);

/** The Voronoi edge dual to it. */
DualEdge dualEdge (const DelaunayComplex& complex, const Facet& facet);

} // namespace manifold
} // namespace pcl
