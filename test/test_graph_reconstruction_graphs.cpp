// The public class: other searches and other graphs.
#include "test_graph_runs.h"

#include <gtest/gtest.h>
#include <pcl/search/impl/brute_force.hpp>
#include <pcl/search/kdtree.h>

namespace {

using namespace graph_runs;
using pcl::manifold::NeighborhoodGraph;

TEST (GraphReconstructionSearch, IsTheUsersOwnIfThereIsOne)
{
  const auto cloud = cloudOf (evenly ("torus", 5000));
  Reconstruction own;
  own.object.setInputCloud (cloud);
  EXPECT_FALSE (own ());
  Reconstruction users;
  users.object.setInputCloud (cloud);
  const auto tree = std::make_shared<pcl::search::KdTree<pcl::PointXYZ>> ();
  users.object.setSearchMethod (tree);
  EXPECT_FALSE (users ());
  EXPECT_EQ (tree->getInputCloud (), cloud);
  EXPECT_EQ (faces (users.polygons), faces (own.polygons));
}

/** Knows all points, whatever it is told, and counts. */
class StubbornSearch : public pcl::search::BruteForce<pcl::PointXYZ>
{
public:
  void setInputCloud (const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& cloud,
                      const pcl::IndicesConstPtr&) override
  {
    pcl::search::BruteForce<pcl::PointXYZ>::setInputCloud (cloud, {});
  }

  int nearestKSearch (const pcl::PointXYZ& point, int k, pcl::Indices& found,
                      std::vector<float>& distances) const override
  {
    ++queries;
    return pcl::search::BruteForce<pcl::PointXYZ>::nearestKSearch (point, k, found, distances);
  }

  mutable std::size_t queries = 0;
};

TEST (GraphReconstructionSearch, IsAskedAgainWhereItAnswersWithDuplicates)
{
  const std::vector<Eigen::Vector3f> once = evenly ("torus", 500);
  std::vector<Eigen::Vector3f> often = once;
  for (int i = 0; i < 6; ++i)
    often.insert (often.end (), once.begin (), once.end ());
  Reconstruction own;
  Reconstruction users;
  const auto search = std::make_shared<StubbornSearch> ();
  own.object.setInputCloud (cloudOf (once));
  users.object.setInputCloud (cloudOf (often));
  users.object.setSearchMethod (search);
  own.object.setHops (1);
  users.object.setHops (1);
  own.object.setKSearch (5);
  users.object.setKSearch (5);
  own ();
  users ();
  EXPECT_GT (search->queries, once.size ());
  EXPECT_EQ (users.object.getNeighborhoodGraph ().neighbors, own.object.getNeighborhoodGraph ().neighbors);
}

/** Finds nothing, or what is not there. */
class UselessSearch : public StubbornSearch
{
public:
  explicit UselessSearch (const pcl::Indices& answer) : answer_ (answer) {}

  int nearestKSearch (const pcl::PointXYZ&, int, pcl::Indices& found, std::vector<float>&) const override
  {
    found = answer_;
    return static_cast<int> (found.size ());
  }

private:
  pcl::Indices answer_;
};

TEST (GraphReconstructionSearch, MayFail)
{
  for (const pcl::Indices& answer : {pcl::Indices{}, pcl::Indices{-1, 1000000, 3}}) {
    Reconstruction run;
    run.object.setInputCloud (cloudOf (torusAndKnot ()));
    run.object.setSearchMethod (std::make_shared<UselessSearch> (answer));
    run ();
    EXPECT_EQ (run.object.getStatus (), Status::DIMENSION_TOO_LOW);
  }
}

TEST (GraphReconstructionGraph, IsEnough)
{
  MeshReconstruction run;
  run.object.setNeighborhoodGraph (graphOf (evenly ("torus", 20000)));
  run.object.setHops (5);
  for (const bool triangulate : {true, false}) {
    run.object.setTriangulate (triangulate);
    run ();
    EXPECT_EQ (run.object.getStatus (), Status::OK);
    expectClosedOfGenus (run.object.getReport (), 1);
    EXPECT_FALSE (run.mesh.polygons.empty ());
    EXPECT_TRUE (run.mesh.cloud.data.empty ());
  }
}

TEST (GraphReconstructionGraph, GivesWhatThePointsGive)
{
  const auto cloud = cloudOf (evenly ("torus", 5000));
  Reconstruction by_points;
  by_points.object.setInputCloud (cloud);
  by_points.object.setTriangulate (false);
  EXPECT_FALSE (by_points ());

  Reconstruction by_graph;
  by_graph.object.setNeighborhoodGraph (
    std::make_shared<NeighborhoodGraph> (by_points.object.getNeighborhoodGraph ()));
  by_graph.object.setTriangulate (false);
  EXPECT_FALSE (by_graph ());
  // Which side is outside is beyond a graph.
  const pcl::Indices& vertices = by_points.object.getVertices ();
  std::multiset<pcl::Indices> turned;
  for (pcl::Vertices polygon : by_graph.polygons) {
    std::reverse (polygon.vertices.begin (), polygon.vertices.end ());
    turned.merge (faces ({polygon}, {vertices.begin (), vertices.end ()}));
  }
  const std::multiset<pcl::Indices> expected = faces (by_points.polygons);
  EXPECT_TRUE (turned == expected ||
               faces (by_graph.polygons, {vertices.begin (), vertices.end ()}) == expected);
}

TEST (GraphReconstructionGraph, IsMended)
{
  const std::vector<Eigen::Vector3f> points = evenly ("torus", 5000);
  const std::shared_ptr<const NeighborhoodGraph> proper = graphOf (points);
  // Every edge one way only, some twice, and a loop at every vertex.
  auto broken = std::make_shared<NeighborhoodGraph> ();
  broken->offsets.push_back (0);
  for (pcl::index_t v = 0; v < proper->size (); ++v) {
    broken->neighbors.push_back (v);
    for (const pcl::index_t* w = proper->end (v); w != proper->begin (v);)
      if (*--w < v)
        broken->neighbors.insert (broken->neighbors.end (), v % 3 == 0 ? 2 : 1, *w);
    broken->offsets.push_back (broken->neighbors.size ());
  }
  Reconstruction runs[2];
  runs[0].object.setNeighborhoodGraph (proper);
  runs[1].object.setNeighborhoodGraph (broken);
  for (Reconstruction& run : runs)
    EXPECT_FALSE (run ());
  EXPECT_EQ (runs[1].object.getNeighborhoodGraph ().neighbors, proper->neighbors);
  EXPECT_EQ (faces (runs[0].polygons), faces (runs[1].polygons));
}

TEST (GraphReconstructionGraph, IsRefusedIfItMeansNothing)
{
  const NeighborhoodGraph good = *graphOf (evenly ("torus", 500));
  std::vector<NeighborhoodGraph> wrong (5, good);
  wrong[0].neighbors[7] = good.size ();
  wrong[1].neighbors[7] = -1;
  std::swap (wrong[2].offsets[3], wrong[2].offsets[4]);
  wrong[3].neighbors.pop_back ();
  wrong[4].offsets.front () = 1;
  for (const NeighborhoodGraph& graph : wrong) {
    Reconstruction run;
    run.object.setNeighborhoodGraph (std::make_shared<NeighborhoodGraph> (graph));
    expectFailure (run, Status::PARAMETER_OUT_OF_RANGE);
    run.object.setNeighborhoodGraph (std::make_shared<NeighborhoodGraph> (good));
    run ();
    EXPECT_NE (run.object.getNeighborhoodGraph ().size (), 0);
  }
}

TEST (GraphReconstructionGraph, NeedsThreeVertices)
{
  Reconstruction run;
  run.object.setNeighborhoodGraph (std::make_shared<NeighborhoodGraph> ());
  expectFailure (run, Status::NO_INPUT);
  run.object.setNeighborhoodGraph (std::make_shared<NeighborhoodGraph> (NeighborhoodGraph{{0, 1, 1}, {1}}));
  expectFailure (run, Status::TOO_FEW_POINTS);
  // Three that nothing joins.
  run.object.setNeighborhoodGraph (std::make_shared<NeighborhoodGraph> (NeighborhoodGraph{{0, 0, 0, 0}, {}}));
  run ();
  EXPECT_EQ (run.object.getStatus (), Status::DIMENSION_TOO_LOW);
  EXPECT_EQ (run.object.getLandmarks ().size (), 3U);
  EXPECT_EQ (run.object.getReport ().vertices, 0U);
}

TEST (GraphReconstructionGraph, MayFallApart)
{
  std::vector<Eigen::Vector3f> points = evenly ("torus", 10000);
  for (const Eigen::Vector3f& p : evenly ("sphere", 10000))
    points.push_back (p + Eigen::Vector3f (10.0f, 0.0f, 0.0f));
  Reconstruction run;
  run.object.setNeighborhoodGraph (graphOf (points));
  run.object.setHops (5);
  EXPECT_FALSE (run ());
  EXPECT_EQ (run.object.getReport ().surface.components.size (), 2U);
}

TEST (GraphReconstructionGraph, MayBeOverThePointsOfACloud)
{
  const std::vector<Eigen::Vector3f> torus = evenly ("torus", 3000);
  std::vector<Eigen::Vector3f> points (100, Eigen::Vector3f (1.0f, 2.0f, 3.0f));
  points.insert (points.end (), torus.begin (), torus.end ());
  const auto indices = std::make_shared<pcl::Indices> ();
  for (std::size_t i = 100; i < points.size (); ++i)
    indices->push_back (static_cast<pcl::index_t> (i));
  MeshReconstruction run;
  run.object.setInputCloud (cloudOf (points));
  run.object.setNeighborhoodGraph (graphOf (torus));
  expectFailure (run, Status::PARAMETER_OUT_OF_RANGE); // of another size than the cloud
  run.object.setIndices (indices);
  EXPECT_FALSE (run ());
  EXPECT_EQ (run.mesh.cloud.width, points.size ());
  for (const pcl::Vertices& polygon : run.mesh.polygons)
    for (const pcl::index_t vertex : polygon.vertices)
      ASSERT_GE (vertex, 100);
  run.object.setIndices (std::make_shared<pcl::Indices> ());
  expectFailure (run, Status::NO_INPUT);
  // Without the graph it is a cloud like any other.
  run.object.setIndices (indices);
  run.object.setNeighborhoodGraph (nullptr);
  EXPECT_FALSE (run ());
}

} // namespace
