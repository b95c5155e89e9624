#pragma once

#include "extraction/sample_roles.h"

#include <cstdint>
#include <vector>

namespace pcl {
namespace manifold {

/** A colour, 0 or 1, for every cell of the Delaunay complex such that surfaces lie where the colour changes:
 * as in the labelling of Power Crust (Amenta, Choi, Kolluri), cells whose circumspheres intersect deeply get
 * the same colour and the two poles of a surface sample opposite ones, the surest of all these wishes first.
 * Unlike there, nothing is said of the outside in advance, so that both sides of an open sheet, or of a
 * one-sided one, get their colours as well: the change of colour that this needs somewhere in free space is
 * no candidate for a triangle.
 *
 * \param[in] closed gives all infinite cells one colour, 0: then where the colour changes, surfaces are
 * closed
 *
 * Equivalent to a maximum spanning forest over cells: O (m log m) for m cells. */
std::vector<std::uint8_t> colorCells (const SampleDimensions& dimensions, const std::vector<Role>& roles,
                                      bool closed);

/** How deeply the circumspheres of the two cells at a facet intersect: the cosine of the angle at which they
 * do, 1 where they are the same. */
double intersectionDepth (const DelaunayComplex& complex, std::int32_t cell, int facet);

} // namespace manifold
} // namespace pcl
