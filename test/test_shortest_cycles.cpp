// FaceRule::SHORTEST_CYCLES against a list of all cycles.
#include "oracle_graph_kinds.h"
#include "oracle_landmark_mesh.h"
#include "oracle_tilings.h"

#include <gtest/gtest.h>

namespace {

using namespace oracle;
using pcl::manifold::FaceRule;

// All cycles of a length, from their smallest vertex on to the smaller neighbour, in ascending order.
std::vector<Walk>
allCycles (int n, const EdgeSet& edges, std::size_t length)
{
  std::vector<Walk> cycles;
  Walk path;
  const auto joined = [&edges] (index_t a, index_t b) { return edges.count (std::minmax (a, b)) > 0; };
  const std::function<void ()> extend = [&] {
    if (path.size () == length) {
      if (joined (path.front (), path.back ()) && path[1] < path.back ())
        cycles.push_back (path);
      return;
    }
    for (index_t v = path.front () + 1; v < n; ++v)
      if (joined (path.back (), v) && std::find (path.begin (), path.end (), v) == path.end ()) {
        path.push_back (v);
        extend ();
        path.pop_back ();
      }
  };
  for (index_t start = 0; start < n; ++start) {
    path.assign (1, start);
    extend ();
  }
  return cycles;
}

std::multiset<Walk>
takenGreedily (int n, const EdgeSet& edges, std::size_t maximum_length)
{
  std::map<LandmarkMesh::Edge, int> uses;
  std::multiset<Walk> faces;
  for (std::size_t length = 3; length <= maximum_length; ++length)
    for (const Walk& cycle : allCycles (n, edges, length)) {
      bool is_free = true;
      for (std::size_t i = 0; i < length; ++i)
        is_free = is_free && uses[sideOf (cycle, i)] < 2;
      if (!is_free)
        continue;
      for (std::size_t i = 0; i < length; ++i)
        ++uses[sideOf (cycle, i)];
      faces.insert (cycle);
    }
  return faces;
}

EdgeSet
edgesWithoutLoops (const NeighborhoodGraph& graph)
{
  EdgeSet edges;
  for (const auto& [v, w] : edgesOf (graph))
    edges.insert (std::minmax (v, w));
  return edges;
}

TEST (ShortestCycles, AreTakenAsDefined)
{
  forEachGraph (60, 11, [] (const NeighborhoodGraph& graph, const std::string& name) {
    const EdgeSet edges = edgesWithoutLoops (graph);
    const TiledGraph tiled (graph.size (), edges);
    for (const int maximum_length : {3, 4, 5, 7}) {
      const LandmarkMesh mesh = tiled.findFaces (FaceRule::SHORTEST_CYCLES, maximum_length);
      EXPECT_EQ (mesh.edges.size (), edges.size ()) << name;
      EXPECT_EQ (normalizedAll (mesh.faces),
                 takenGreedily (graph.size (), edges, static_cast<std::size_t> (maximum_length)))
        << name << ", up to " << maximum_length;
      EXPECT_TRUE (mesh.holes.empty ());
      expectSound (mesh, tiled.contacts, tiled.tiles.size (), maximum_length, false, name);
      if (testing::Test::HasFailure ())
        return;
    }
  });
}

TEST (ShortestCycles, PassAdjacentTilesOnly)
{
  TiledGraph tiled (4, {{0, 1}, {1, 2}, {2, 3}, {0, 3}, {0, 2}});
  tiled.contacts[1].adjacent = false; // of 0 and 2
  ASSERT_EQ (tiled.contacts[1].second, 2);
  const LandmarkMesh mesh = tiled.findFaces (FaceRule::SHORTEST_CYCLES, 8);
  EXPECT_EQ (mesh.edges.size (), 4u);
  EXPECT_EQ (mesh.faces, std::vector<Walk> ({{0, 1, 2, 3}}));
}

TEST (ShortestCycles, AreTheTrianglesOfATorus)
{
  const Tiling torus = gridTiling ("torus", 7, 9, true, true, false);
  const TiledGraph tiled (torus.vertices, torus.edges ());
  const LandmarkMesh mesh = tiled.findFaces (FaceRule::SHORTEST_CYCLES, 8);
  EXPECT_EQ (mesh.faces.size (), torus.triangles.size ());
  EXPECT_EQ (analyze (mesh).surface.components.front ().genus, 1);
}

TEST (ShortestCycles, HaveALongestLength)
{
  for (const int n : {3, 8, 31, 32, 33}) {
    EdgeSet edges = pathOf (n);
    edges.emplace (0, n - 1);
    const TiledGraph tiled (n, edges);
    for (const int maximum_length : {n - 1, n, 1000000})
      EXPECT_EQ (tiled.findFaces (FaceRule::SHORTEST_CYCLES, maximum_length).faces.size (),
                 (maximum_length >= n && n <= 32) || n == 3 ? 1u : 0u)
        << n << ", up to " << maximum_length;
  }
}

TEST (ShortestCycles, AreTheSameOnAnyNumberOfThreads)
{
  const NeighborhoodGraph graph = largeGraph ();
  const std::vector<index_t> landmarks = maximalStableSet (graph, 4, 1, 1);
  const std::vector<index_t> tiles = graphVoronoiDiagram (graph, landmarks, 1);
  const std::vector<TileContact> contacts =
    tileContacts (graph, landmarks, tiles, pcl::manifold::AdjacencyRule::BOUNDARY_POINTS, 7, 1);
  const auto facesWith = [&] (unsigned int threads) {
    return findFaces (graph, tiles, landmarks.size (), contacts, FaceRule::SHORTEST_CYCLES, 8, threads).faces;
  };
  EXPECT_FALSE (facesWith (1).empty ());
  EXPECT_EQ (facesWith (1), facesWith (2));
}

} // namespace
