// Stable sets against their definition, by the hops between all pairs of vertices.
#include "oracle_graph_kinds.h"

#include "graph/landmarks/priority.h"

#include <gtest/gtest.h>

#include <tbb/global_control.h>

#include <limits>
#include <numeric>

namespace {

using namespace oracle;
using pcl::manifold::maximalStableSet;
using pcl::manifold::priorityOf;

constexpr int MANY_HOPS = std::numeric_limits<int>::max ();

std::vector<index_t>
byPriority (index_t n, std::uint64_t seed)
{
  std::vector<index_t> order (static_cast<std::size_t> (n));
  std::iota (order.begin (), order.end (), 0);
  std::sort (order.begin (), order.end (), [seed] (index_t v, index_t w) {
    return std::make_pair (priorityOf (v, seed), v) < std::make_pair (priorityOf (w, seed), w);
  });
  return order;
}

void
expectStableAndMaximal (const Hops& hops, const std::vector<index_t>& landmarks, int k)
{
  ASSERT_TRUE (std::is_sorted (landmarks.begin (), landmarks.end ()));
  for (std::size_t v = 0; v < hops.size (); ++v) {
    int nearest = UNREACHABLE;
    for (const index_t w : landmarks)
      if (static_cast<std::size_t> (w) != v)
        nearest = std::min (nearest, hops[v][static_cast<std::size_t> (w)]);
    if (std::binary_search (landmarks.begin (), landmarks.end (), static_cast<index_t> (v)))
      ASSERT_GE (nearest, std::min (k, UNREACHABLE)) << "landmark " << v;
    else
      ASSERT_LT (nearest, std::min (k, UNREACHABLE)) << "vertex " << v << " could be added";
  }
}

TEST (StableSet, IsTheGreedyOne)
{
  std::uint64_t seed = 0;
  forEachGraph (80, 130, [&] (const NeighborhoodGraph& graph, const std::string& name) {
    SCOPED_TRACE (name);
    const Hops hops = hopsBetweenAll (graph);
    ++seed;
    for (const int k : {1, 2, 3, 4, 5, 7, 12, 1000, MANY_HOPS}) {
      const std::vector<index_t> landmarks = maximalStableSet (graph, k, seed, 1);
      ASSERT_EQ (landmarks,
                 stableSetInOrder (hops, std::min (k, UNREACHABLE), byPriority (graph.size (), seed)))
        << k << " hops";
      expectStableAndMaximal (hops, landmarks, k);
      if (testing::Test::HasFatalFailure ())
        return;
    }
  });
}

TEST (StableSet, HasEveryVertexWithOneHop)
{
  const std::vector<index_t> landmarks = maximalStableSet (graphOfEdges (50, pathOf (50)), 1, 3, 2);
  std::vector<index_t> all (50);
  std::iota (all.begin (), all.end (), 0);
  EXPECT_EQ (landmarks, all);
}

TEST (StableSet, HasOneVertexAComponentWithMoreHopsThanTheDiameter)
{
  EdgeSet edges = pathOf (40);
  edges.erase ({19, 20});
  for (const int k : {20, 21, 1000, MANY_HOPS}) {
    const std::vector<index_t> landmarks = maximalStableSet (graphOfEdges (40, edges), k, 9, 2);
    ASSERT_EQ (landmarks.size (), 2u) << k;
    EXPECT_LT (landmarks[0], 20);
    EXPECT_GE (landmarks[1], 20);
  }
}

TEST (StableSet, DependsOnTheSeed)
{
  const NeighborhoodGraph graph = graphOfEdges (400, gridEdges (400, 20, false));
  EXPECT_NE (maximalStableSet (graph, 4, 1, 1), maximalStableSet (graph, 4, 2, 1));
}

// Several threads search around many candidates at a time, of which some exclude each other.
TEST (StableSet, IsTheSameForAnyNumberOfThreads)
{
  const tbb::global_control four (tbb::global_control::max_allowed_parallelism, 4);
  const NeighborhoodGraph graph = largeGraph ();
  for (const int k : {1, 2, 3, 5, 9, 30}) {
    const std::vector<index_t> expected = maximalStableSet (graph, k, 11, 1);
    ASSERT_FALSE (expected.empty ());
    for (const unsigned int threads : {0u, 2u, 4u})
      ASSERT_EQ (maximalStableSet (graph, k, 11, threads), expected) << k << " hops, threads " << threads;
  }
}

TEST (StableSet, PrioritiesOfASeedDiffer)
{
  for (const std::uint64_t seed : {0ull, 1ull, 123456789ull}) {
    std::set<std::uint64_t> priorities;
    for (index_t v = 0; v < 100000; ++v)
      priorities.insert (priorityOf (v, seed));
    EXPECT_EQ (priorities.size (), 100000u);
  }
}

} // namespace
