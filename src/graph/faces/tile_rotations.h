#pragma once

#include "graph/faces/meeting_points.h"
#include "graph/landmarks/contact_rows.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace manifold {

/** How much speaks for two tiles, that touch a third one, to follow each other around it: meeting points of
 * all three and, less, the contact of the two. Both count by their logarithms, because no evidence at all
 * against a single point says more than ten points against fifteen. In units of FOLLOW_BIT. */
std::int32_t followWeight (std::int32_t meeting_points, std::int32_t boundary_points);

constexpr std::int32_t FOLLOW_BIT = 1280;

/** The order in which tiles follow each other along the border of each tile, all that it touches, also those
 * that are not adjacent to it.
 *
 * Tile t has the places starts[t] to starts[t + 1] - 1 of the rows of contacts; they are a cycle. Parts of it
 * that could as well be the other way round are arcs of their own. */
struct TileRotations
{
  std::vector<std::size_t> contact_at;       ///< per place the contact that is there
  std::vector<std::size_t> place_of;         ///< per contact its place
  std::vector<std::int32_t> meeting_points;  ///< per place, of the tile and those at this place and the next
  std::vector<std::int32_t> cost_of_turning; ///< per place, the least of the parts that end there
  std::vector<std::size_t> arc;              ///< per place the first one of its arc
  std::vector<std::uint8_t> whole;           ///< per tile: is it one arc without ends?

  /** All but the arcs: every tile is one. Parallel over the tiles in the current arena. */
  TileRotations (const ContactRows& rows, const MeetingPoints& meetings);

  /** Makes arcs of the parts of rotations that less than this speaks against turning. */
  void breakIntoArcs (const ContactRows& rows, std::int32_t free_to_turn);

  /** Turns an arc of a tile the other way round, within its places.
   * \return the end of its places */
  std::size_t reverseArc (const ContactRows& rows, const MeetingPoints& meetings, pcl::index_t tile,
                          std::size_t first);
};

} // namespace manifold
} // namespace pcl
