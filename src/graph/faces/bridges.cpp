#include "graph/faces/bridges.h"

#include <algorithm>
#include <utility>

namespace pcl {
namespace manifold {

using Dart = RotationSystem::Dart;

Bridges::Bridges (const RotationSystem& system)
  : system_ (system), known_ (static_cast<std::size_t> (system.size ()), 0)
{
  pcl::index_t tiles = 0;
  for (Dart dart = 0; dart < system.size (); ++dart)
    tiles = std::max (tiles, system.from (dart) + 1);
  seen_by_.assign (static_cast<std::size_t> (tiles), 0);
  findBridges ();
}

// Tarjan's depth first search: the edge to a tile is a bridge if no edge from it or from beyond leads back.
void
Bridges::findBridges ()
{
  std::vector<std::uint32_t> entered (seen_by_.size (), 0);
  std::vector<std::uint32_t> lowest (seen_by_.size (), 0);
  // Darts on the way from the root, by the dart at the tile that they led to; and the next dart to try there.
  std::vector<std::pair<Dart, Dart>> way;
  std::uint32_t time = 0;
  const auto enter = [&] (pcl::index_t tile, Dart back, Dart first) {
    entered[tile] = lowest[tile] = ++time;
    way.emplace_back (back, first);
  };
  for (Dart root = 0; root < system_.size (); ++root) {
    if (!system_.hasDart (root) || entered[system_.from (root)] != 0)
      continue;
    enter (system_.from (root), -1, root);
    while (!way.empty ()) {
      auto& [back, current] = way.back ();
      if (current < 0) {
        const Dart done = back;
        way.pop_back ();
        if (done < 0)
          continue;
        const pcl::index_t tile = system_.from (done);
        const pcl::index_t parent = system_.to (done);
        lowest[parent] = std::min (lowest[parent], lowest[tile]);
        if (lowest[tile] > entered[parent])
          known_[done] = known_[system_.twin (done)] = 1;
        continue;
      }
      const Dart dart = current;
      const Dart first = back < 0 ? root : back;
      current = system_.next (dart) != first ? system_.next (dart) : -1;
      if (dart == back)
        continue;
      const pcl::index_t tile = system_.from (dart);
      const pcl::index_t other = system_.to (dart);
      if (entered[other] != 0)
        lowest[tile] = std::min (lowest[tile], entered[other]);
      else
        enter (other, system_.twin (dart), system_.twin (dart));
    }
  }
}

bool
Bridges::isBridge (Dart dart)
{
  if (known_[dart] != 0)
    return true;
  ++search_;
  const pcl::index_t ends[2] = {system_.from (dart), system_.to (dart)};
  for (int side = 0; side < 2; ++side) {
    region_[side].assign (1, ends[side]);
    grown_[side] = 0;
    seen_by_[ends[side]] = 2 * search_ + static_cast<std::uint32_t> (side);
  }
  while (grown_[0] < region_[0].size () && grown_[1] < region_[1].size ())
    for (int side = 0; side < 2; ++side)
      if (growRegion (side, dart))
        return false;
  return true;
}

// Adds the neighbours of the next tile of a region. \return did they meet the other one?
bool
Bridges::growRegion (int side, Dart without)
{
  const std::uint32_t mine = 2 * search_ + static_cast<std::uint32_t> (side);
  const Dart first = system_.anyAt (region_[side][grown_[side]++]);
  Dart dart = first;
  do {
    if (dart != without && dart != system_.twin (without)) {
      std::uint32_t& seen = seen_by_[system_.to (dart)];
      if (seen == (mine ^ 1u))
        return true;
      if (seen != mine)
        region_[side].push_back (system_.to (dart));
      seen = mine;
    }
    dart = system_.next (dart);
  } while (dart != first);
  return false;
}

} // namespace manifold
} // namespace pcl
