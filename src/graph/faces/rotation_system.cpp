#include "graph/faces/rotation_system.h"

#include <algorithm>

namespace pcl {
namespace manifold {

RotationSystem::RotationSystem (const ContactRows& rows, const TileRotations& rotations,
                                const std::vector<std::uint8_t>& opposite)
  : any_at_ (rows.tiles (), NONE)
{
  std::vector<Dart> dart_of (rows.tile.size (), NONE);
  for (std::size_t tile = 0; tile < rows.tiles (); ++tile)
    addTile (rows, rotations, opposite, static_cast<pcl::index_t> (tile), dart_of);
  for (std::size_t tile = 0; tile < rows.tiles (); ++tile)
    for (std::size_t contact = rows.starts[tile]; contact < rows.starts[tile + 1]; ++contact)
      if (dart_of[contact] != NONE)
        darts_[dart_of[contact]].twin =
          dart_of[rows.find (rows.tile[contact], static_cast<pcl::index_t> (tile))];
}

void
RotationSystem::addTile (const ContactRows& rows, const TileRotations& rotations,
                         const std::vector<std::uint8_t>& opposite, pcl::index_t tile,
                         std::vector<Dart>& dart_of)
{
  // A tile that touches without being adjacent leaves a corner that is as weak as the weaker of its two.
  constexpr std::int32_t NOT_KNOWN = -1;
  const auto weaken = [] (std::int32_t& points, std::int32_t other) {
    points = points == NOT_KNOWN ? other : std::min (points, other);
  };
  const Dart first = size ();
  std::int32_t before_first = NOT_KNOWN;
  for (std::size_t place = rows.starts[tile]; place < rows.starts[tile + 1]; ++place) {
    const std::size_t contact = rotations.contact_at[place];
    if (rows.adjacent[contact] != 0) {
      const Dart dart = size ();
      dart_of[contact] = dart;
      darts_.push_back ({tile, NONE, dart + 1, dart - 1, dart, opposite[contact] != 0});
      corners_.push_back ({dart, rotations.meeting_points[place]});
    } else
      weaken (size () > first ? corners_.back ().meeting_points : before_first,
              rotations.meeting_points[place]);
  }
  if (size () == first)
    return;
  darts_.back ().next = first;
  darts_[first].previous = size () - 1;
  if (before_first != NOT_KNOWN)
    weaken (corners_.back ().meeting_points, before_first);
  any_at_[tile] = first;
}

void
RotationSystem::follow (Corner start, Walk& walk) const
{
  walk.clear ();
  Passage passage{start, true};
  do {
    walk.push_back (passage);
    passage = follow (passage);
  } while (passage.corner != start);
}

void
RotationSystem::remove (Dart dart)
{
  for (const Dart end : {dart, twin (dart)}) {
    DartData& data = darts_[end];
    CornerData& before = corners_[cornerBefore (end)];
    before.meeting_points = std::min (before.meeting_points, corners_[data.corner].meeting_points);
    corners_[data.corner].dart = NONE;
    darts_[data.previous].next = data.next;
    darts_[data.next].previous = data.previous;
    any_at_[data.from] = data.next != end ? data.next : NONE;
    data.next = data.previous = NONE;
  }
}

void
RotationSystem::putAfter (Dart dart, Corner corner)
{
  darts_[dart].corner = corner;
  corners_[corner].dart = dart;
}

void
RotationSystem::turn (Corner first, Corner second, std::int32_t first_points, std::int32_t second_points)
{
  const Dart before = firstOf (first);
  const Dart after = secondOf (second);
  std::vector<Dart> turned;
  std::vector<Corner> between;
  for (Dart dart = secondOf (first); dart != after; dart = next (dart)) {
    turned.push_back (dart);
    between.push_back (cornerAfter (dart));
    darts_[dart].opposite = !darts_[dart].opposite;
    darts_[twin (dart)].opposite = darts_[dart].opposite;
  }
  between.pop_back ();
  Dart last = before;
  const auto append = [&] (Corner corner, Dart dart) {
    putAfter (last, corner);
    darts_[last].next = dart;
    darts_[dart].previous = last;
    last = dart;
  };
  append (first, turned.back ());
  for (std::size_t i = between.size (); i-- > 0;)
    append (between[i], turned[i]);
  append (second, after);
  corners_[first].meeting_points = first_points;
  corners_[second].meeting_points = second_points;
}

} // namespace manifold
} // namespace pcl
