#include "graph/faces/walk_repair.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace pcl {
namespace manifold {

namespace {

using Dart = RotationSystem::Dart;

// Evidence against turning that is more than this is not overruled by what it does to one walk: three bits.
constexpr std::int32_t MOST_COST = 3 * FOLLOW_BIT;

// An edge of so few boundary points is rather wrong than any order.
constexpr std::int32_t WEAK = 12;
constexpr std::int32_t STRONGEST = std::numeric_limits<std::int32_t>::max ();

// An edge that crosses another one in a hole has points at two of its four corners at least.
constexpr int CORNERS_OF_CROSSING = 2;

// A walk that passes more edges twice is beyond repair step by step, and so is one that passes a tile more
// often.
constexpr std::size_t MANY_EDGES = 32;
constexpr std::size_t MANY_PASSAGES = 8;

} // namespace

WalkRepair::WalkRepair (const ContactRows& rows, const MeetingPoints& meetings, RotationSystem& system)
  : rows_ (rows), meetings_ (meetings), system_ (system), bridges_ (system),
    passed_in_ (static_cast<std::size_t> (system.size ()), 0)
{}

bool
WalkRepair::mend (const Walk& walk, bool is_hole)
{
  edgesPassedTwice (walk);
  const std::vector<Candidate> candidates = crossingEdges (is_hole);
  if (twice_.size () > MANY_EDGES)
    return removeWeakest (candidates, candidates.size () / 4 + 1, STRONGEST);
  return removeWeakest (candidates, 1, WEAK) || turnCheapest (walk, is_hole) ||
         removeWeakest (candidates, 1, STRONGEST);
}

const std::vector<Dart>&
WalkRepair::edgesPassedTwice (const Walk& walk)
{
  ++walk_;
  twice_.clear ();
  for (const RotationSystem::Passage passage : walk) {
    const Dart dart = system_.leavesAlong (passage);
    const Dart edge = std::min (dart, system_.twin (dart));
    if (passed_in_[edge] == walk_)
      twice_.push_back (edge);
    passed_in_[edge] = walk_;
  }
  return twice_;
}

// The points that see a tile and the ends of two of its darts.
std::int32_t
WalkRepair::meetingPoints (Dart a, Dart b) const
{
  return a == b ? 0 : meetings_.count (system_.from (a), system_.to (a), system_.to (b));
}

// How much speaks for two darts following each other around their tile.
std::int32_t
WalkRepair::weight (Dart a, Dart b) const
{
  return a == b ? 0 : followWeight (meetingPoints (a, b), rows_.strength (system_.to (a), system_.to (b)));
}

std::int32_t
WalkRepair::costOfTurning (Corner first, Corner second) const
{
  const Dart darts[2][2] = {{system_.firstOf (first), system_.secondOf (first)},
                            {system_.firstOf (second), system_.secondOf (second)}};
  return weight (darts[0][0], darts[0][1]) + weight (darts[1][0], darts[1][1]) -
         weight (darts[0][0], darts[1][0]) - weight (darts[0][1], darts[1][1]);
}

bool
WalkRepair::turnCheapest (const Walk& walk, bool is_hole)
{
  by_tile_.resize (walk.size ());
  for (std::uint32_t i = 0; i < walk.size (); ++i)
    by_tile_[i] = i;
  const auto tileAt = [&] (std::uint32_t i) { return system_.tileOf (walk[i].corner); };
  std::sort (by_tile_.begin (), by_tile_.end (), [&] (std::uint32_t i, std::uint32_t j) {
    return tileAt (i) != tileAt (j) ? tileAt (i) < tileAt (j) : i < j;
  });
  std::int32_t least = MOST_COST;
  Corner first = RotationSystem::NONE;
  Corner second = RotationSystem::NONE;
  for (std::size_t i = 0; i < by_tile_.size (); ++i)
    for (std::size_t j = i + 1;
         j < std::min (by_tile_.size (), i + MANY_PASSAGES) && tileAt (by_tile_[j]) == tileAt (by_tile_[i]);
         ++j) {
      const RotationSystem::Passage a = walk[by_tile_[i]];
      const RotationSystem::Passage b = walk[by_tile_[j]];
      if (a.forward == b.forward || (is_hole && system_.isOpen (a.corner) && system_.isOpen (b.corner)))
        continue;
      const std::int32_t cost = costOfTurning (a.corner, b.corner);
      if (cost >= least)
        continue;
      least = cost;
      first = a.corner;
      second = b.corner;
    }
  if (first == RotationSystem::NONE)
    return false;
  system_.turn (first, second, meetingPoints (system_.firstOf (first), system_.firstOf (second)),
                meetingPoints (system_.secondOf (first), system_.secondOf (second)));
  return true;
}

// How many of the four corners at an edge are not open.
int
WalkRepair::closedCornersAt (Dart dart) const
{
  int closed = 0;
  for (const Dart end : {dart, system_.twin (dart)})
    closed += (system_.isOpen (system_.cornerAfter (end)) ? 0 : 1) +
              (system_.isOpen (system_.cornerBefore (end)) ? 0 : 1);
  return closed;
}

// The edges that the walk passes twice and that may cross others, the weakest first.
std::vector<WalkRepair::Candidate>
WalkRepair::crossingEdges (bool is_hole) const
{
  std::vector<Candidate> candidates;
  for (const Dart dart : twice_)
    if (!is_hole || closedCornersAt (dart) >= CORNERS_OF_CROSSING)
      candidates.emplace_back (rows_.strength (system_.from (dart), system_.to (dart)), dart);
  std::sort (candidates.begin (), candidates.end ());
  return candidates;
}

// Removes some edges that are at most so strong, and without which no part falls off.
bool
WalkRepair::removeWeakest (const std::vector<Candidate>& candidates, std::size_t most, std::int32_t strength)
{
  std::size_t removed = 0;
  for (const auto& [boundary_points, dart] : candidates)
    if (removed < most && boundary_points <= strength && !bridges_.isBridge (dart)) {
      system_.remove (dart);
      ++removed;
    }
  return removed > 0;
}

} // namespace manifold
} // namespace pcl
