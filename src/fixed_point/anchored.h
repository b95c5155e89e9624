#pragma once

#include <pcl/manifold/fixed_point_complex.h>

#include "extraction/facet_set.h"

#include <cstdint>
#include <vector>

namespace pcl {
namespace manifold {

/** The anchored triangles, those that meet their own dual Voronoi edges: the circumcentre is in the triangle,
 * and no sample is nearer to it than its corners. Exact; ascending, each as the facet of its cell with the
 * smaller number. Parallel in the current arena. */
std::vector<Facet> anchoredTriangles (const DelaunayComplex& complex);

} // namespace manifold
} // namespace pcl
