// Contacts of tiles against counts over all edges, and the path rule against hops between all vertices.
#include "oracle_graph_kinds.h"

#include <gtest/gtest.h>

#include <tbb/global_control.h>

namespace {

using namespace oracle;
using pcl::manifold::AdjacencyRule;
using pcl::manifold::graphVoronoiDiagram;
using pcl::manifold::maximalStableSet;
using pcl::manifold::tileContacts;

void
expectEqual (const std::vector<TileContact>& contacts, const std::vector<TileContact>& expected,
             const std::string& name)
{
  ASSERT_EQ (contacts.size (), expected.size ()) << name;
  for (std::size_t i = 0; i < contacts.size (); ++i) {
    ASSERT_EQ (contacts[i].first, expected[i].first) << name;
    ASSERT_EQ (contacts[i].second, expected[i].second) << name;
    ASSERT_EQ (contacts[i].boundary_points, expected[i].boundary_points) << name;
    ASSERT_EQ (contacts[i].linking_edges, expected[i].linking_edges) << name;
    ASSERT_EQ (contacts[i].adjacent, expected[i].adjacent)
      << name << ", contact of " << contacts[i].first << " and " << contacts[i].second;
  }
}

void
checkAllRules (const NeighborhoodGraph& graph, const std::vector<index_t>& landmarks, const std::string& name)
{
  const Hops hops = hopsBetweenAll (graph);
  const std::vector<index_t> tiles = graphVoronoiDiagram (graph, landmarks, 1);
  std::vector<TileContact> expected = contactsByPairs (graph, tiles);
  for (const int threshold : {-1, 0, 1, 2, 7, 1000}) {
    for (TileContact& contact : expected)
      contact.adjacent = contact.boundary_points > threshold;
    expectEqual (tileContacts (graph, landmarks, tiles, AdjacencyRule::BOUNDARY_POINTS, threshold, 1),
                 expected, name + ", boundary points");
    for (TileContact& contact : expected)
      contact.adjacent = contact.linking_edges > threshold;
    expectEqual (tileContacts (graph, landmarks, tiles, AdjacencyRule::LINKING_EDGES, threshold, 2), expected,
                 name + ", linking edges");
  }
  for (TileContact& contact : expected)
    contact.adjacent = hasClearPath (graph, hops, landmarks, tiles, contact.first, contact.second);
  for (const unsigned int threads : {1u, 2u})
    expectEqual (tileContacts (graph, landmarks, tiles, AdjacencyRule::CLEAR_PATH, 0, threads), expected,
                 name + ", clear path");
}

TEST (TileContacts, AreCountedAndJudgedAsDefined)
{
  std::uint64_t seed = 0;
  forEachGraph (80, 90, [&] (const NeighborhoodGraph& graph, const std::string& name) {
    for (const int k : {1, 2, 3, 5, 9}) {
      checkAllRules (graph, maximalStableSet (graph, k, ++seed, 1), name + ", k " + std::to_string (k));
      if (testing::Test::HasFatalFailure ())
        return;
    }
  });
}

// Landmarks anywhere: tiles of very different size, and vertices in none.
TEST (TileContacts, OfAnyLandmarks)
{
  int round = 0;
  forEachGraph (60, 90, [&] (const NeighborhoodGraph& graph, const std::string& name) {
    Random random (static_cast<std::uint64_t> (++round));
    std::set<index_t> landmarks;
    for (int i = random.integer (0, 12); i > 0 && graph.size () > 0; --i)
      landmarks.insert (random.index (graph.size ()));
    checkAllRules (graph, {landmarks.begin (), landmarks.end ()}, name);
  });
}

TEST (TileContacts, OfAPathByHand)
{
  // Tiles 0 0 0 1 1 1: the two vertices in the middle are the boundary.
  const NeighborhoodGraph path = graphOfEdges (6, pathOf (6));
  const std::vector<index_t> tiles = graphVoronoiDiagram (path, {1, 4}, 1);
  ASSERT_EQ (tiles, (std::vector<index_t>{0, 0, 0, 1, 1, 1}));
  const auto contacts = tileContacts (path, {1, 4}, tiles, AdjacencyRule::BOUNDARY_POINTS, 1, 1);
  ASSERT_EQ (contacts.size (), 1u);
  EXPECT_EQ (contacts[0].boundary_points, 2);
  EXPECT_EQ (contacts[0].linking_edges, 1);
  EXPECT_TRUE (contacts[0].adjacent);
  EXPECT_FALSE (tileContacts (path, {1, 4}, tiles, AdjacencyRule::BOUNDARY_POINTS, 2, 1)[0].adjacent);
  EXPECT_FALSE (tileContacts (path, {1, 4}, tiles, AdjacencyRule::LINKING_EDGES, 1, 1)[0].adjacent);
  EXPECT_TRUE (tileContacts (path, {1, 4}, tiles, AdjacencyRule::CLEAR_PATH, 1, 1)[0].adjacent);
}

TEST (TileContacts, AThirdTileBlocksThePath)
{
  // 0 1 2 3 4 5 with a branch 6 at vertex 2, whose end is a tile of its own.
  EdgeSet edges = pathOf (6);
  edges.emplace (2, 6);
  const NeighborhoodGraph graph = graphOfEdges (7, edges);
  const std::vector<index_t> landmarks{1, 4, 6};
  const std::vector<index_t> tiles{0, 0, 0, 1, 1, 1, 2};
  const auto contacts = tileContacts (graph, landmarks, tiles, AdjacencyRule::CLEAR_PATH, 0, 1);
  ASSERT_EQ (contacts.size (), 2u);
  EXPECT_FALSE (contacts[0].adjacent); // 0 and 1: vertex 2 is next to tile 2
  EXPECT_FALSE (contacts[1].adjacent); // 0 and 2: vertex 2 is next to tile 1
}

TEST (TileContacts, AreTheSameForAnyNumberOfThreads)
{
  const tbb::global_control four (tbb::global_control::max_allowed_parallelism, 4);
  const NeighborhoodGraph graph = largeGraph ();
  for (const int k : {2, 4, 6}) {
    const std::vector<index_t> landmarks = maximalStableSet (graph, k, 5, 1);
    const std::vector<index_t> tiles = graphVoronoiDiagram (graph, landmarks, 1);
    for (const AdjacencyRule rule :
         {AdjacencyRule::BOUNDARY_POINTS, AdjacencyRule::LINKING_EDGES, AdjacencyRule::CLEAR_PATH}) {
      const auto expected = tileContacts (graph, landmarks, tiles, rule, 7, 1);
      ASSERT_FALSE (expected.empty ());
      ASSERT_EQ (expected.size (), contactsByPairs (graph, tiles).size ());
      for (const unsigned int threads : {0u, 2u, 4u})
        expectEqual (tileContacts (graph, landmarks, tiles, rule, 7, threads), expected,
                     std::to_string (threads) + " threads");
    }
  }
}

} // namespace
