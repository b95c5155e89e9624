#pragma once

#include "extraction/facet_set.h"

namespace pcl {
namespace manifold {

/** The squared radius of the smallest circumsphere of a Delaunay triangle. */
double squaredCircumradius (const DelaunayComplex& complex, std::int32_t cell, int facet);

/** The cosine of the dihedral angle between the triangles (a, b, c) and (a, b, d): -1 where they continue
 * each other in a plane, 1 where they are folded onto each other. */
double dihedralCosine (const DelaunayComplex& complex, std::int32_t a, std::int32_t b, std::int32_t c,
                       std::int32_t d);

/** The mean length of the edges of a surface at a sample; 0 where it has none. */
double meanEdge (const FacetSet& surface, std::int32_t sample);

} // namespace manifold
} // namespace pcl
