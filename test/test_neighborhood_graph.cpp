// Neighbourhood graphs against sets of edges and a look at all points.
#include "oracle_graph_kinds.h"

#include <gtest/gtest.h>

#include <tbb/global_control.h>

#include <limits>

namespace {

using namespace oracle;
using pcl::manifold::isProper;
using pcl::manifold::nearestNeighborGraph;
using pcl::manifold::Status;
using pcl::manifold::symmetrize;

void
expectEqual (const NeighborhoodGraph& a, const NeighborhoodGraph& b, const std::string& name)
{
  ASSERT_EQ (a.offsets, b.offsets) << name;
  ASSERT_EQ (a.neighbors, b.neighbors) << name;
}

// A graph that was left in an output must not survive a failure.
NeighborhoodGraph
leftover ()
{
  return graphOfEdges (3, pathOf (3));
}

TEST (NeighborhoodGraph, IsProperAsDescribed)
{
  forEachGraph (60, 60, [] (const NeighborhoodGraph& graph, const std::string& name) {
    std::string why = "unset";
    ASSERT_TRUE (isProper (graph, &why)) << name << ": " << why;
    ASSERT_EQ (why, "") << name;
    ASSERT_TRUE (isProper (graph)) << name;
  });
}

TEST (NeighborhoodGraph, SaysWhatIsNotProper)
{
  const auto whyOf = [] (const std::vector<std::size_t>& offsets, const std::vector<index_t>& neighbors) {
    std::string why;
    EXPECT_FALSE (isProper ({offsets, neighbors}, &why));
    EXPECT_FALSE (isProper ({offsets, neighbors}));
    return why;
  };
  EXPECT_EQ (whyOf ({}, {0}), "there are neighbours but no offsets");
  EXPECT_EQ (whyOf ({1, 2}, {0, 0}), "the first offset is 1 instead of 0");
  EXPECT_EQ (whyOf ({0, 1, 3}, {1, 0}), "the last offset is 3, but there are 2 neighbours");
  EXPECT_EQ (whyOf ({0, 3, 1, 2}, {1, 0}), "the offsets descend after vertex 1");
  EXPECT_EQ (whyOf ({0, 1, 2}, {1, 2}), "vertex 1 has the neighbour 2 of 2 vertices");
  EXPECT_EQ (whyOf ({0, 1, 2}, {1, -1}), "vertex 1 has the neighbour -1 of 2 vertices");
  EXPECT_EQ (whyOf ({0, 1, 2}, {1, 1}), "vertex 1 is its own neighbour");
  EXPECT_EQ (whyOf ({0, 2, 3, 4}, {2, 1, 0, 0}), "vertex 0 has the neighbour 1 after 2");
  EXPECT_EQ (whyOf ({0, 2, 3}, {1, 1, 0}), "vertex 0 has the neighbour 1 after 1");
  EXPECT_EQ (whyOf ({0, 1, 2, 2}, {1, 2}), "vertex 0 has the neighbour 1, which does not have it");
}

// Of the definition: every damage to a proper graph must be noticed.
bool
isProperBySets (const NeighborhoodGraph& graph)
{
  EdgeSet edges;
  for (index_t v = 0; v < graph.size (); ++v)
    for (const index_t* w = graph.begin (v); w != graph.end (v); ++w)
      if (*w == v || *w < 0 || *w >= graph.size () || !edges.emplace (v, *w).second ||
          (w != graph.begin (v) && *(w - 1) > *w))
        return false;
  return std::all_of (edges.begin (), edges.end (), [&] (const std::pair<index_t, index_t>& edge) {
    return edges.count ({edge.second, edge.first}) != 0;
  });
}

TEST (NeighborhoodGraph, NoticesDamage)
{
  int damaged = 0;
  forEachGraph (60, 200, [&] (const NeighborhoodGraph& graph, const std::string& name) {
    Random random (static_cast<std::uint64_t> (graph.neighbors.size ()));
    for (int i = 0; i < 20 && !graph.neighbors.empty (); ++i) {
      NeighborhoodGraph changed = graph;
      changed
        .neighbors[static_cast<std::size_t> (random.index (static_cast<int> (graph.neighbors.size ())))] =
        random.integer (-1, graph.size ());
      const bool proper = isProperBySets (changed);
      damaged += proper ? 0 : 1;
      std::string why;
      ASSERT_EQ (isProper (changed, &why), proper) << name << ": " << why;
      ASSERT_EQ (why.empty (), proper) << name;
    }
  });
  EXPECT_GT (damaged, 5000);
}

// Rows as users may give them: in any order, with repetitions, self loops and edges one way only.
TEST (NeighborhoodGraph, SymmetrizesAnyRows)
{
  int round = 0;
  forEachGraph (150, 120, [&] (const NeighborhoodGraph& graph, const std::string& name) {
    Random random (static_cast<std::uint64_t> (++round));
    std::vector<std::vector<index_t>> rows (static_cast<std::size_t> (graph.size ()));
    EdgeSet edges;
    for (index_t v = 0; v < graph.size (); ++v) {
      std::vector<index_t>& row = rows[static_cast<std::size_t> (v)];
      for (const index_t* w = graph.begin (v); w != graph.end (v); ++w)
        for (int times = random.index (3); times > 0; --times)
          row.push_back (*w);
      if (random.coin ())
        row.push_back (v);
      for (std::size_t i = row.size (); i > 1; --i)
        std::swap (row[i - 1], row[static_cast<std::size_t> (random.index (static_cast<int> (i)))]);
      for (const index_t w : row)
        edges.emplace (v, w);
    }
    for (const unsigned int threads : {0u, 1u, 2u}) {
      NeighborhoodGraph result = leftover ();
      const Status status = symmetrize (graphOfRows (rows), threads, result);
      ASSERT_EQ (status, graph.size () == 0 ? Status::NO_INPUT : Status::OK) << name;
      if (graph.size () == 0)
        expectEqual (result, NeighborhoodGraph (), name);
      else
        expectEqual (result, graphOfEdges (graph.size (), edges), name);
      ASSERT_TRUE (isProper (result)) << name;
    }
  });
}

TEST (NeighborhoodGraph, SymmetrizesInPlace)
{
  NeighborhoodGraph graph = graphOfRows ({{1, 2}, {}, {0, 2}});
  ASSERT_EQ (symmetrize (graph, 1, graph), Status::OK);
  expectEqual (graph, graphOfEdges (3, {{0, 1}, {0, 2}}), "in place");
}

// Rows to which all parts of the graph add.
TEST (NeighborhoodGraph, SymmetrizesHubs)
{
  const tbb::global_control four (tbb::global_control::max_allowed_parallelism, 4);
  constexpr index_t N = 200000;
  constexpr index_t HUBS = 50;
  std::vector<std::vector<index_t>> rows (N);
  std::vector<std::vector<index_t>> expected (N);
  for (index_t v = HUBS; v < N; ++v) {
    rows[static_cast<std::size_t> (v)] = expected[static_cast<std::size_t> (v)] = {v % HUBS};
    expected[static_cast<std::size_t> (v % HUBS)].push_back (v);
  }
  for (const unsigned int threads : {1u, 2u, 4u}) {
    NeighborhoodGraph graph;
    ASSERT_EQ (symmetrize (graphOfRows (rows), threads, graph), Status::OK);
    expectEqual (graph, graphOfRows (expected), std::to_string (threads));
  }
}

TEST (NeighborhoodGraph, RefusesRowsOutOfRange)
{
  const std::vector<NeighborhoodGraph> wrong{
    {{}, {0}},     {{1, 1}, {0}},        {{0, 2}, {0}},       {{0, 2, 1, 3}, {0, 0, 0}},
    {{0, 1}, {1}}, {{0, 1, 2}, {1, -1}}, {{0, 0, 1}, {0, 1}},
  };
  for (std::size_t i = 0; i < wrong.size (); ++i) {
    NeighborhoodGraph result = leftover ();
    EXPECT_EQ (symmetrize (wrong[i], 1, result), Status::PARAMETER_OUT_OF_RANGE) << i;
    expectEqual (result, NeighborhoodGraph (), std::to_string (i));
  }
}

TEST (NeighborhoodGraph, JoinsNearestNeighbors)
{
  for (int round = 0; round < 600; ++round) {
    Random random (static_cast<std::uint64_t> (round));
    const int n = round < 30 ? 1 + round / 2 : random.integer (1, 70);
    const Eigen::MatrixXd points = randomPoints (random.integer (1, 7), n, random);
    for (const int k : {1, random.integer (1, 20), n - 1, n, std::numeric_limits<int>::max ()}) {
      if (k < 1)
        continue;
      NeighborhoodGraph graph = leftover ();
      ASSERT_EQ (nearestNeighborGraph (points, k, round % 3, graph), Status::OK);
      expectEqual (graph, graphOfEdges (n, edgesOf (nearestByLookingAtAll (points, k))),
                   "round " + std::to_string (round) + ", k " + std::to_string (k));
    }
  }
}

TEST (NeighborhoodGraph, TakesAPartOfAMatrix)
{
  Random random (3);
  const Eigen::MatrixXd all = Eigen::MatrixXd::NullaryExpr (
    5, 60, [&random] (Eigen::Index, Eigen::Index) { return random.uniform (); });
  NeighborhoodGraph graph;
  ASSERT_EQ (nearestNeighborGraph (all.block (1, 10, 3, 40), 4, 1, graph), Status::OK);
  expectEqual (graph, graphOfEdges (40, edgesOf (nearestByLookingAtAll (all.block (1, 10, 3, 40), 4))),
               "block");
}

TEST (NeighborhoodGraph, RefusesPointsAndKOutOfRange)
{
  const auto statusOf = [] (const Eigen::MatrixXd& points, int k) {
    NeighborhoodGraph graph = leftover ();
    const Status status = nearestNeighborGraph (points, k, 1, graph);
    EXPECT_EQ (graph.size (), 0);
    EXPECT_TRUE (graph.neighbors.empty ());
    return status;
  };
  Eigen::MatrixXd points = Eigen::MatrixXd::Identity (3, 3);
  EXPECT_EQ (statusOf (points, 0), Status::PARAMETER_OUT_OF_RANGE);
  EXPECT_EQ (statusOf (points, -5), Status::PARAMETER_OUT_OF_RANGE);
  EXPECT_EQ (statusOf (Eigen::MatrixXd (3, 0), 5), Status::NO_INPUT);
  EXPECT_EQ (statusOf (Eigen::MatrixXd (0, 3), 5), Status::NO_INPUT);
  EXPECT_EQ (statusOf (points * 1e155, 2), Status::INPUT_OUT_OF_RANGE);
  EXPECT_EQ (statusOf (points * -1e308, 2), Status::INPUT_OUT_OF_RANGE);
  for (const double wrong :
       {std::numeric_limits<double>::quiet_NaN (), std::numeric_limits<double>::infinity ()}) {
    points (1, 2) = wrong;
    EXPECT_EQ (statusOf (points, 2), Status::INPUT_OUT_OF_RANGE);
  }
}

TEST (NeighborhoodGraph, IsTheSameForAnyNumberOfThreads)
{
  Random random (21);
  Eigen::MatrixXd points (4, 30000);
  for (Eigen::Index i = 0; i < points.cols (); ++i)
    points.col (i) << random.uniform (), random.uniform (), 0.01 * random.uniform (), 0.0;
  NeighborhoodGraph expected;
  ASSERT_EQ (nearestNeighborGraph (points, 9, 1, expected), Status::OK);
  ASSERT_TRUE (isProper (expected));
  const tbb::global_control four (tbb::global_control::max_allowed_parallelism, 4);
  for (const unsigned int threads : {0u, 2u, 4u}) {
    NeighborhoodGraph graph;
    ASSERT_EQ (nearestNeighborGraph (points, 9, threads, graph), Status::OK);
    expectEqual (graph, expected, std::to_string (threads));
    ASSERT_EQ (symmetrize (expected, threads, graph), Status::OK);
    expectEqual (graph, expected, std::to_string (threads));
  }
}

} // namespace
