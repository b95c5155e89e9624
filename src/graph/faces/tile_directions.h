#pragma once

#include "graph/faces/tile_rotations.h"

#include <cstdint>
#include <vector>

namespace pcl {
namespace manifold {

/** Finds out which adjacent tiles have rotations that go round the surface in opposite directions, as seen
 * from the tiles that both touch: those follow in one rotation and precede in the other if not.
 *
 * What few or no common neighbours tell is overruled by what others tell together. Arcs that could be either
 * way round are turned so that the tiles around them agree; where a surface is one-sided, some tiles will not
 * agree however arcs are turned.
 * \return per contact whether the two go in opposite directions; 0 for tiles that are not adjacent */
std::vector<std::uint8_t> alignRotations (const ContactRows& rows, const MeetingPoints& meetings,
                                          TileRotations& rotations);

} // namespace manifold
} // namespace pcl
