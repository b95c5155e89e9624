#include "graph/faces/face_walks.h"

#include "graph/faces/walk_repair.h"

#include <algorithm>
#include <utility>

namespace pcl {
namespace manifold {

namespace {

using Corner = RotationSystem::Corner;

// Shorter walks around a gap in the sample look like faces.
constexpr std::size_t SHORTEST_HOLE = 5;

LandmarkMesh::Edge
toEdge (pcl::index_t a, pcl::index_t b)
{
  return {std::min (a, b), std::max (a, b)};
}

} // namespace

FaceWalks::FaceWalks (const ContactRows& rows, const MeetingPoints& meetings, int maximum_length,
                      RotationSystem& system)
  : rows_ (rows), system_ (system), maximum_length_ (static_cast<std::size_t> (maximum_length)),
    traced_ (static_cast<std::size_t> (system.size ()), 0), long_faces_ (rows, maximum_length_)
{
  repair (meetings);
  dropLooseHoles ();
}

std::vector<LandmarkMesh::Edge>
FaceWalks::edges () const
{
  std::vector<Edge> edges = wires_;
  edges.insert (edges.end (), long_faces_.chords ().begin (), long_faces_.chords ().end ());
  for (Dart dart = 0; dart < system_.size (); ++dart)
    if (system_.hasDart (dart) && system_.from (dart) < system_.to (dart))
      edges.push_back (toEdge (system_.from (dart), system_.to (dart)));
  std::sort (edges.begin (), edges.end ());
  return edges;
}

// Follows the walk that passes a corner, unless it is gone or was followed before.
bool
FaceWalks::trace (Corner start, Walk& walk)
{
  if (!system_.hasCorner (start) || traced_[start] != 0)
    return false;
  system_.follow (start, walk);
  for (const RotationSystem::Passage passage : walk)
    traced_[passage.corner] = 1;
  return true;
}

bool
FaceWalks::isHole (const Walk& walk) const
{
  const auto open = static_cast<std::size_t> (
    std::count_if (walk.begin (), walk.end (), [this] (const RotationSystem::Passage passage) {
      return system_.isOpen (passage.corner);
    }));
  if (walk.size () <= SHORTEST_HOLE)
    return walk.size () == SHORTEST_HOLE && open == walk.size ();
  return walk.size () > maximum_length_ ? 2 * open >= walk.size () : 4 * open >= 3 * walk.size ();
}

void
FaceWalks::repair (const MeetingPoints& meetings)
{
  WalkRepair repair (rows_, meetings, system_);
  Walk walk;
  std::vector<Corner> waiting;
  for (Corner start = 0; start < system_.size (); ++start)
    for (waiting.assign (1, start); !waiting.empty ();) {
      const Corner corner = waiting.back ();
      waiting.pop_back ();
      if (!trace (corner, walk))
        continue;
      const bool is_hole = isHole (walk);
      if (repair.mend (walk, is_hole) || detach (repair.edgesPassedTwice (walk))) {
        // Other walks may now pass their corners in the other direction, but are the same.
        for (const RotationSystem::Passage passage : walk) {
          traced_[passage.corner] = 0;
          waiting.push_back (passage.corner);
        }
        continue;
      }
      Tiles tiles;
      for (const RotationSystem::Passage passage : walk)
        tiles.push_back (system_.tileOf (passage.corner));
      if (is_hole)
        holes_.push_back (std::move (tiles));
      else
        long_faces_.cut (std::move (tiles), faces_, holes_);
    }
}

// Takes edges for wires. \return were there any?
bool
FaceWalks::detach (const std::vector<Dart>& darts)
{
  for (const Dart dart : darts) {
    wires_.push_back (toEdge (system_.from (dart), system_.to (dart)));
    system_.remove (dart);
  }
  return !darts.empty ();
}

// A closed curve has a hole on either side, but no boundary.
void
FaceWalks::dropLooseHoles ()
{
  std::vector<Edge> sides;
  for (const Tiles& face : faces_)
    for (std::size_t i = 0; i < face.size (); ++i)
      sides.push_back (toEdge (face[i], face[i + 1 < face.size () ? i + 1 : 0]));
  std::sort (sides.begin (), sides.end ());
  const auto isLoose = [&sides] (const Tiles& hole) {
    for (std::size_t i = 0; i < hole.size (); ++i)
      if (std::binary_search (sides.begin (), sides.end (),
                              toEdge (hole[i], hole[i + 1 < hole.size () ? i + 1 : 0])))
        return false;
    return true;
  };
  holes_.erase (std::remove_if (holes_.begin (), holes_.end (), isLoose), holes_.end ());
}

} // namespace manifold
} // namespace pcl
