// What changing a rotation system does to its walks, and its bridges against counts of components.
#include "oracle_graph_kinds.h"
#include "oracle_landmark_mesh.h"
#include "oracle_tilings.h"

#include "graph/faces/bridges.h"
#include "graph/faces/tile_directions.h"

#include <gtest/gtest.h>

namespace {

using namespace oracle;
using pcl::manifold::Bridges;
using pcl::manifold::ContactRows;
using pcl::manifold::MeetingPoints;
using pcl::manifold::RotationSystem;
using pcl::manifold::TileRotations;

using Corner = RotationSystem::Corner;
using Dart = RotationSystem::Dart;

// With orders around tiles as they are found, but directions at random.
RotationSystem
systemOf (const TiledGraph& tiled, Random& random)
{
  const ContactRows rows (tiled.tiles.size (), tiled.contacts);
  const MeetingPoints meetings (tiled.graph, tiled.tiles, tiled.tiles.size ());
  TileRotations rotations (rows, meetings);
  rotations.breakIntoArcs (rows, pcl::manifold::FOLLOW_BIT);
  std::vector<std::uint8_t> opposite = alignRotations (rows, meetings, rotations);
  for (const TileContact& contact : tiled.contacts)
    opposite[rows.find (contact.first, contact.second)] =
      opposite[rows.find (contact.second, contact.first)] = random.coin () ? 1 : 0;
  return RotationSystem (rows, rotations, opposite);
}

// The walks of a system, and which of them passes each corner, and how.
struct Walks
{
  std::vector<RotationSystem::Walk> walks;
  std::vector<int> walk_of;
  std::vector<bool> forward;
};

Walks
walksOf (const RotationSystem& system)
{
  Walks result;
  result.walk_of.assign (static_cast<std::size_t> (system.size ()), -1);
  result.forward.assign (result.walk_of.size (), false);
  for (Corner start = 0; start < system.size (); ++start) {
    if (!system.hasCorner (start) || result.walk_of[static_cast<std::size_t> (start)] >= 0)
      continue;
    result.walks.emplace_back ();
    system.follow (start, result.walks.back ());
    for (const RotationSystem::Passage passage : result.walks.back ()) {
      const auto corner = static_cast<std::size_t> (passage.corner);
      EXPECT_EQ (result.walk_of[corner], -1) << "passed twice";
      result.walk_of[corner] = static_cast<int> (result.walks.size ()) - 1;
      result.forward[corner] = passage.forward;
    }
  }
  return result;
}

// Every corner in one walk, walks along edges, every edge passed twice, tiles' darts in one cycle.
void
expectConsistent (const RotationSystem& system, const std::string& name)
{
  const Walks walks = walksOf (system);
  std::map<Dart, int> passed;
  for (const RotationSystem::Walk& walk : walks.walks)
    for (std::size_t i = 0; i < walk.size (); ++i) {
      const Dart out = system.leavesAlong (walk[i]);
      ++passed[std::min (out, system.twin (out))];
      ASSERT_EQ (system.tileOf (walk[i].corner), system.from (out)) << name;
      ASSERT_EQ (system.tileOf (walk[(i + 1) % walk.size ()].corner), system.to (out)) << name;
    }
  for (Dart dart = 0; dart < system.size (); ++dart) {
    if (!system.hasDart (dart))
      continue;
    ASSERT_EQ (passed[std::min (dart, system.twin (dart))], 2) << name;
    ASSERT_EQ (system.twin (system.twin (dart)), dart) << name;
    ASSERT_EQ (system.firstOf (system.cornerAfter (dart)), dart) << name;
    ASSERT_EQ (system.secondOf (system.cornerBefore (dart)), dart) << name;
    ASSERT_EQ (system.from (system.next (dart)), system.from (dart)) << name;
    ASSERT_GE (walks.walk_of[static_cast<std::size_t> (system.cornerAfter (dart))], 0) << name;
  }
}

// Two corners of a tile that the same walk passes in opposite directions, if there are any.
bool
findTurn (const RotationSystem& system, const Walks& walks, Random& random, Corner& first, Corner& second)
{
  std::vector<std::pair<Corner, Corner>> found;
  for (Corner a = 0; a < system.size (); ++a)
    for (Corner b = 0; b < system.size (); ++b) {
      const auto i = static_cast<std::size_t> (a), j = static_cast<std::size_t> (b);
      if (a != b && system.hasCorner (a) && system.hasCorner (b) && walks.walk_of[i] == walks.walk_of[j] &&
          system.tileOf (a) == system.tileOf (b) && walks.forward[i] != walks.forward[j])
        found.emplace_back (a, b);
    }
  if (found.empty ())
    return false;
  std::tie (first, second) =
    found[static_cast<std::size_t> (random.index (static_cast<int> (found.size ())))];
  return true;
}

TEST (RotationSystem, KeepsItsWalksConsistent)
{
  std::uint64_t seed = 0;
  int turned = 0;
  forEachGraph (12, 25, [&] (const NeighborhoodGraph& graph, const std::string& name) {
    Random random (++seed);
    EdgeSet edges;
    for (const auto& [v, w] : edgesOf (graph))
      edges.insert (std::minmax (v, w));
    RotationSystem system = systemOf (TiledGraph (graph.size (), edges), random);
    ASSERT_EQ (system.size (), static_cast<std::int32_t> (2 * edges.size ())) << name;
    expectConsistent (system, name);
    for (int step = 0; step < 30 && !testing::Test::HasFatalFailure (); ++step) {
      const Walks before = walksOf (system);
      Corner first = 0, second = 0;
      if (random.coin () && findTurn (system, before, random, first, second)) {
        ++turned;
        system.turn (first, second, 3, 0);
        EXPECT_EQ (walksOf (system).walks.size (), before.walks.size () + 1) << name;
        EXPECT_FALSE (system.isOpen (first));
        EXPECT_TRUE (system.isOpen (second));
      } else if (system.size () > 0) {
        const Dart dart = random.index (system.size ());
        if (!system.hasDart (dart))
          continue;
        const auto a = static_cast<std::size_t> (system.cornerAfter (dart));
        const auto b = static_cast<std::size_t> (system.cornerBefore (dart));
        const bool alone =
          system.next (dart) == dart || system.next (system.twin (dart)) == system.twin (dart);
        const bool parted = before.walk_of[a] != before.walk_of[b];
        const int change = alone ? 0 : parted ? -1 : before.forward[a] == before.forward[b] ? 1 : 0;
        system.remove (dart);
        if (!alone) {
          EXPECT_EQ (static_cast<int> (walksOf (system).walks.size ()),
                     static_cast<int> (before.walks.size ()) + change)
            << name;
        }
      }
      expectConsistent (system, name);
    }
  });
  EXPECT_GT (turned, 100);
}

std::vector<LandmarkMesh::Edge>
edgesOf (const RotationSystem& system, Dart without)
{
  std::vector<LandmarkMesh::Edge> edges;
  for (Dart dart = 0; dart < system.size (); ++dart)
    if (system.hasDart (dart) && dart < system.twin (dart) && dart != without &&
        system.twin (dart) != without)
      edges.push_back (
        {std::min (system.from (dart), system.to (dart)), std::max (system.from (dart), system.to (dart))});
  return edges;
}

TEST (Bridges, AreEdgesWithoutWhichAPartFallsOff)
{
  std::uint64_t seed = 0;
  int bridges_found = 0;
  forEachGraph (16, 20, [&] (const NeighborhoodGraph& graph, const std::string& name) {
    Random random (++seed);
    EdgeSet edges;
    for (const auto& [v, w] : oracle::edgesOf (graph))
      edges.insert (std::minmax (v, w));
    const auto n = static_cast<std::size_t> (graph.size ());
    RotationSystem system = systemOf (TiledGraph (graph.size (), edges), random);
    Bridges bridges (system);
    for (int removed = 0; removed < 6; ++removed) {
      for (Dart dart = 0; dart < system.size (); ++dart)
        if (system.hasDart (dart)) {
          const bool expected = countParts (n, edgesOf (system, dart)) > countParts (n, edgesOf (system, -1));
          bridges_found += expected ? 1 : 0;
          ASSERT_EQ (bridges.isBridge (dart), expected) << name;
        }
      const Dart dart = system.size () > 0 ? random.index (system.size ()) : 0;
      if (system.size () > 0 && system.hasDart (dart))
        system.remove (dart);
    }
  });
  EXPECT_GT (bridges_found, 100);
}

} // namespace
