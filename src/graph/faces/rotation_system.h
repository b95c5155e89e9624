#pragma once

#include "graph/faces/tile_rotations.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace manifold {

/** The graph of adjacent tiles, embedded in a surface: the cyclic order of the edges around every tile, and
 * for every edge whether the orders at its two ends go in opposite directions (a general rotation system).
 * It always is the embedding in some closed surface: faces are closed walks, the facial walks, and every edge
 * is passed twice by them.
 *
 * Edges are pairs of darts (half-edges), one at each end. A corner is between two darts that follow each
 * other.
 */
class RotationSystem
{
public:
  using Dart = std::int32_t;
  using Corner = std::int32_t;

  static constexpr std::int32_t NONE = -1;

  /** How a walk passes a corner: it comes along one of its darts and leaves along the other. Every corner is
   * passed once, by one walk. */
  struct Passage
  {
    Corner corner;
    bool forward; ///< does the walk leave along the second dart of the corner?
  };

  using Walk = std::vector<Passage>;

  /** \param[in] opposite of alignRotations */
  RotationSystem (const ContactRows& rows, const TileRotations& rotations,
                  const std::vector<std::uint8_t>& opposite);

  /** How many darts, and corners, there were in the beginning. Those that are still there keep their numbers.
   */
  std::int32_t size () const { return static_cast<std::int32_t> (darts_.size ()); }

  bool hasDart (Dart dart) const { return darts_[dart].next != NONE; }

  bool hasCorner (Corner corner) const { return corners_[corner].dart != NONE; }

  /** The tile at which a dart is. */
  pcl::index_t from (Dart dart) const { return darts_[dart].from; }

  pcl::index_t to (Dart dart) const { return darts_[darts_[dart].twin].from; }

  Dart twin (Dart dart) const { return darts_[dart].twin; }

  Dart next (Dart dart) const { return darts_[dart].next; }

  Corner cornerAfter (Dart dart) const { return darts_[dart].corner; }

  Corner cornerBefore (Dart dart) const { return darts_[darts_[dart].previous].corner; }

  /** The first dart of a corner. */
  Dart firstOf (Corner corner) const { return corners_[corner].dart; }

  Dart secondOf (Corner corner) const { return darts_[corners_[corner].dart].next; }

  /** The tile at which a corner is. */
  pcl::index_t tileOf (Corner corner) const { return darts_[corners_[corner].dart].from; }

  /** Any dart of a tile, NONE if there is none. */
  Dart anyAt (pcl::index_t tile) const { return any_at_[tile]; }

  /** Does no vertex see the tile and those at both sides of the corner, nor at those of a corner that became
   * part of this one? */
  bool isOpen (Corner corner) const { return corners_[corner].meeting_points == 0; }

  Dart leavesAlong (Passage passage) const
  {
    return passage.forward ? secondOf (passage.corner) : firstOf (passage.corner);
  }

  /** How the walk goes on. */
  Passage follow (Passage passage) const
  {
    const Dart out = leavesAlong (passage);
    const Dart in = twin (out);
    const bool forward = passage.forward != darts_[out].opposite;
    return {forward ? cornerAfter (in) : cornerBefore (in), forward};
  }

  /** The walk that passes a corner, from there on and forward. */
  void follow (Corner start, Walk& walk) const;

  /** Removes an edge. At each end two corners become one, that before the dart. */
  void remove (Dart dart);

  /** Turns the darts between two corners of a tile, those after the first one up to the second one, the other
   * way round. If a walk passed both corners in opposite directions, it falls into two.
   * \param[in] first_points, second_points meeting points at the two corners then */
  void turn (Corner first, Corner second, std::int32_t first_points, std::int32_t second_points);

private:
  struct DartData
  {
    pcl::index_t from;
    Dart twin;
    Dart next; ///< NONE once removed
    Dart previous;
    Corner corner;
    bool opposite;
  };

  struct CornerData
  {
    Dart dart; ///< NONE once removed
    std::int32_t meeting_points;
  };

  void addTile (const ContactRows& rows, const TileRotations& rotations,
                const std::vector<std::uint8_t>& opposite, pcl::index_t tile, std::vector<Dart>& dart_of);
  void putAfter (Dart dart, Corner corner);

  std::vector<DartData> darts_;
  std::vector<CornerData> corners_;
  std::vector<Dart> any_at_;
};

} // namespace manifold
} // namespace pcl
