// Graph Voronoi diagrams against the hops from every vertex to every landmark.
#include "oracle_graph_kinds.h"

#include <gtest/gtest.h>

#include <tbb/global_control.h>

namespace {

using namespace oracle;
using pcl::manifold::graphVoronoiDiagram;
using pcl::manifold::maximalStableSet;

std::vector<index_t>
randomLandmarks (index_t n, int count, Random& random)
{
  std::set<index_t> landmarks;
  for (int i = 0; i < count && n > 0; ++i)
    landmarks.insert (random.index (n));
  return {landmarks.begin (), landmarks.end ()};
}

TEST (GraphVoronoi, HasTheNearestLandmarks)
{
  int round = 0;
  forEachGraph (150, 150, [&] (const NeighborhoodGraph& graph, const std::string& name) {
    Random random (static_cast<std::uint64_t> (++round));
    const Hops hops = hopsBetweenAll (graph);
    for (const int count : {0, 1, 2, 5, 20, 1000}) {
      std::vector<index_t> landmarks = randomLandmarks (graph.size (), count, random);
      // The number of a landmark is its position, whatever the order.
      if (random.coin ())
        std::reverse (landmarks.begin (), landmarks.end ());
      for (const unsigned int threads : {1u, 2u})
        ASSERT_EQ (graphVoronoiDiagram (graph, landmarks, threads), tilesByHops (hops, landmarks))
          << name << ", " << landmarks.size () << " landmarks";
    }
  });
}

TEST (GraphVoronoi, GivesTiesToTheSmallestNumber)
{
  const NeighborhoodGraph path = graphOfEdges (5, pathOf (5));
  EXPECT_EQ (graphVoronoiDiagram (path, {0, 4}, 1), (std::vector<index_t>{0, 0, 0, 1, 1}));
  EXPECT_EQ (graphVoronoiDiagram (path, {4, 0}, 1), (std::vector<index_t>{1, 1, 0, 0, 0}));
}

TEST (GraphVoronoi, LeavesOutWhatNoLandmarkReaches)
{
  const NeighborhoodGraph graph = graphOfEdges (5, {{0, 1}, {2, 3}});
  EXPECT_EQ (graphVoronoiDiagram (graph, {3}, 1), (std::vector<index_t>{-1, -1, 0, 0, -1}));
  EXPECT_EQ (graphVoronoiDiagram (graph, {}, 1), std::vector<index_t> (5, -1));
  EXPECT_TRUE (graphVoronoiDiagram (NeighborhoodGraph (), {}, 1).empty ());
}

// Levels of all sizes, small ones after large ones: the comb's teeth end one after the other.
TEST (GraphVoronoi, SpreadsOverLevelsOfAllSizes)
{
  for (int round = 0; round < 100; ++round) {
    Random random (static_cast<std::uint64_t> (round));
    const int teeth = random.integer (1, 60);
    EdgeSet edges = pathOf (teeth);
    int n = teeth;
    for (int tooth = 0; tooth < teeth; ++tooth)
      for (int i = random.integer (0, round); i > 0; --i, ++n)
        edges.emplace (i % 7 == 0 ? tooth : n - 1, n);
    const NeighborhoodGraph graph = graphOfEdges (n, edges);
    const std::vector<index_t> landmarks = randomLandmarks (n, random.integer (1, teeth), random);
    ASSERT_EQ (graphVoronoiDiagram (graph, landmarks, 2), tilesByHops (hopsBetweenAll (graph), landmarks))
      << round;
  }
}

// A search whose time grew with the number of levels times that of vertices would not end here.
TEST (GraphVoronoi, IsLinearOnALongPath)
{
  constexpr index_t N = 2000000;
  NeighborhoodGraph path;
  path.offsets.push_back (0);
  for (index_t v = 0; v < N; ++v) {
    if (v > 0)
      path.neighbors.push_back (v - 1);
    if (v + 1 < N)
      path.neighbors.push_back (v + 1);
    path.offsets.push_back (path.neighbors.size ());
  }
  EXPECT_EQ (graphVoronoiDiagram (path, {0}, 2), std::vector<index_t> (N, 0));
}

TEST (GraphVoronoi, IsTheSameForAnyNumberOfThreads)
{
  const tbb::global_control four (tbb::global_control::max_allowed_parallelism, 4);
  const NeighborhoodGraph graph = largeGraph ();
  for (const int k : {1, 2, 5, 20}) {
    const std::vector<index_t> landmarks = maximalStableSet (graph, k, 5, 1);
    const std::vector<index_t> expected = graphVoronoiDiagram (graph, landmarks, 1);
    for (const unsigned int threads : {0u, 2u, 4u})
      ASSERT_EQ (graphVoronoiDiagram (graph, landmarks, threads), expected) << k << " hops, " << threads;
  }
}

} // namespace
