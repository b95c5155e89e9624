#pragma once

#include "extraction/facet_set.h"
#include "extraction/sample_roles.h"

#include <cstdint>
#include <vector>

namespace pcl {
namespace manifold {

struct CellColors
{
  std::vector<std::uint8_t> colors; ///< 0 or 1 per cell
  std::vector<Facet> torn; ///< facets across which the colour changes in the middle of free space: between
                           ///< cells whose circumspheres are nearly the same
};

/** A colour, 0 or 1, for every cell of the Delaunay complex such that surfaces lie where the colour changes:
 * as in the labelling of Power Crust (Amenta, Choi, Kolluri), cells whose circumspheres intersect deeply get
 * the same colour and the two poles of a surface sample opposite ones. These wishes are the signed edges of a
 * graph over the cells; where they contradict each other the surest ones are granted.
 * Unlike there, nothing is said of the outside in advance, so that both sides of an open sheet, or of a
 * one-sided one, get their colours as well: the change of colour that this needs somewhere in free space is
 * no candidate for a triangle.
 *
 * \param[in] solid the cells that are certain to be inside of a solid, a flag per cell
 * \param[in] closed gives all infinite cells one colour, 0: then where the colour changes, surfaces are
 * closed
 *
 * \param[in] together flags cells that keep the colour of those that they share nearly all of their
 * circumspheres with, before anything less certain; may be empty
 *
 * Equivalent to a maximum spanning forest over cells: O (m log m) for m cells. */
CellColors colorCells (const SampleDimensions& dimensions, const std::vector<Role>& roles,
                       const std::vector<std::uint8_t>& solid, bool closed,
                       const std::vector<std::uint8_t>& together = {});

} // namespace manifold
} // namespace pcl
