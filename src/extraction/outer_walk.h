#pragma once

#include <pcl/manifold/fixed_point_complex.h>

#include <cstdint>
#include <vector>

namespace pcl {
namespace manifold {

/** The extraction of section 8 of Khoury and Shewchuk: a walk from the unbounded outside through the Delaunay
 * tetrahedra that crosses no triangle of a set. The surface is where the tetrahedra that it reached end.
 *
 * The paper first drops triangles with a sharp edge that no other triangle goes on from: those have the walk
 * on both of their sides, or are inside of the surface, and are not part of it anyway.
 * \param[in] facets a set that should enclose something
 * \param[out] colors per cell 0 where the walk came, else 1
 * \return whether the surface passes through every sample: if not, the set has gaps, or parts inside of
 * others, and the surface is of no use */
bool walkOutside (const DelaunayComplex& complex, const FacetFlags& facets,
                  std::vector<std::uint8_t>& colors);

} // namespace manifold
} // namespace pcl
