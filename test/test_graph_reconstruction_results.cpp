// The public class: what comes out has the topology that it should have, and nothing but the points and the
// parameters decides it.
#include "test_graph_runs.h"

#include <gtest/gtest.h>
#include <pcl/manifold/topology_report.h>

#include <tuple>

namespace {

using namespace graph_runs;

/** The topology of polygons of any sizes. */
pcl::manifold::SurfaceTopology
topologyOf (const std::vector<pcl::Vertices>& polygons)
{
  pcl::SimplicialComplex triangles;
  for (const pcl::Vertices& polygon : polygons)
    for (std::size_t i = 2; i < polygon.vertices.size (); ++i)
      triangles.triangles.push_back ({polygon.vertices[0], polygon.vertices[i - 1], polygon.vertices[i]});
  return pcl::manifold::analyze (triangles).surface;
}

class ClosedSurfaces : public testing::TestWithParam<std::pair<const char*, int>>
{};

TEST_P (ClosedSurfaces, HaveTheirGenus)
{
  const auto& [name, genus] = GetParam ();
  Reconstruction run;
  run.object.setInputCloud (cloudOf (evenly (name, 20000)));
  run.object.setHops (5);
  EXPECT_FALSE (run ());
  expectClosedOfGenus (run.object.getReport (), genus);
  EXPECT_EQ (run.object.getReport ().vertices, run.object.getLandmarks ().size ());
  const std::size_t faces = run.object.getReport ().surface.faces; // the next run has its own

  // And so has the mesh that the user gets, whether it was triangulated or not.
  for (const bool triangulate : {true, false}) {
    run.object.setTriangulate (triangulate);
    EXPECT_FALSE (run ());
    const pcl::manifold::SurfaceTopology topology = topologyOf (run.polygons);
    ASSERT_EQ (topology.components.size (), 1U);
    EXPECT_TRUE (topology.isManifold ());
    EXPECT_TRUE (topology.isClosed ());
    EXPECT_TRUE (topology.components[0].orientable);
    EXPECT_EQ (topology.components[0].genus, genus);
    if (triangulate)
      EXPECT_TRUE (std::all_of (run.polygons.begin (), run.polygons.end (),
                                [] (const pcl::Vertices& polygon) { return polygon.vertices.size () == 3; }));
    else
      EXPECT_EQ (run.polygons.size (), faces);
  }
}

INSTANTIATE_TEST_SUITE_P (Shapes, ClosedSurfaces,
                          testing::Values (std::pair ("sphere", 0), std::pair ("torus", 1),
                                           std::pair ("genus3", 3)),
                          [] (const auto& tested) { return std::string (tested.param.first); });

// Where landmarks at five hops from each other are too few, there are more of them.
TEST (GraphReconstruction, SmallAndThinSurfacesHaveTheirGenus)
{
  const auto thin = [] (double radius, double spacing) {
    return floats (generate::blueNoise (generate::torus (1.0, radius), spacing, 3));
  };
  for (const auto& [name, points, genus] :
       {std::tuple ("small sphere", evenly ("sphere", 200), 0),
        std::tuple ("small torus", thin (0.4, 0.13), 1), std::tuple ("thin torus", thin (0.15, 0.05), 1)}) {
    SCOPED_TRACE (name);
    Reconstruction run;
    run.object.setInputCloud (cloudOf (points));
    run.object.setHops (5);
    run.object.setRefine (false);
    run ();
    const std::size_t uniform = run.object.getLandmarks ().size ();
    run.object.setRefine (true);
    EXPECT_FALSE (run ());
    EXPECT_GT (run.object.getLandmarks ().size (), uniform);
    expectClosedOfGenus (run.object.getReport (), genus);
  }
}

/** Six times the volume that triangles enclose, the sum over the cones from the origin. */
double
volume (const std::vector<pcl::Vertices>& polygons, const std::vector<Eigen::Vector3f>& points)
{
  double sum = 0.0;
  for (const pcl::Vertices& polygon : polygons) {
    const auto corner = [&] (std::size_t i) {
      return points[static_cast<std::size_t> (polygon.vertices[i])].cast<double> ().eval ();
    };
    sum += corner (0).dot (corner (1).cross (corner (2)));
  }
  return sum;
}

TEST (GraphReconstruction, TurnsSurfacesOutwards)
{
  std::vector<Eigen::Vector3f> points = evenly ("sphere", 20000);
  const std::size_t of_first = points.size ();
  for (const Eigen::Vector3f& p : evenly ("torus", 20000, 2))
    points.push_back (p + Eigen::Vector3f (100.0f, 50.0f, 0.0f));
  Reconstruction run;
  run.object.setInputCloud (cloudOf (points));
  run.object.setHops (5);
  EXPECT_FALSE (run ());
  std::vector<pcl::Vertices> parts[2];
  for (const pcl::Vertices& polygon : run.polygons)
    parts[static_cast<std::size_t> (polygon.vertices[0]) < of_first ? 0 : 1].push_back (polygon);
  EXPECT_GT (volume (parts[0], points), 0.0);
  EXPECT_GT (volume (parts[1], points), 0.0);
}

TEST (GraphReconstruction, DisjointSurfacesAreComponents)
{
  for (const int surfaces : {2, 3}) {
    std::vector<Eigen::Vector3f> points;
    for (int i = 0; i < surfaces; ++i)
      for (const Eigen::Vector3f& p : evenly (i == 1 ? "torus" : "sphere", 10000 + 1000 * i))
        points.push_back (p + Eigen::Vector3f (5.0f * static_cast<float> (i), 0.0f, 0.0f));
    Reconstruction run;
    run.object.setInputCloud (cloudOf (points));
    run.object.setHops (5);
    EXPECT_FALSE (run ());
    const auto& components = run.object.getReport ().surface.components;
    EXPECT_EQ (run.object.getReport ().curve.edges, 0U);
    ASSERT_EQ (components.size (), static_cast<std::size_t> (surfaces));
    int genera = 0;
    for (const pcl::manifold::SurfaceComponent& component : components) {
      EXPECT_EQ (component.inner_edges, component.edges);
      genera += component.genus;
    }
    EXPECT_EQ (genera, 1);
  }
}

TEST (GraphReconstruction, BoundaryLoopsAreCounted)
{
  for (const auto& [name, loops] : {std::pair ("hemisphere", 1U), std::pair ("annulus", 2U)}) {
    SCOPED_TRACE (name);
    Reconstruction run;
    run.object.setInputCloud (cloudOf (evenly (name, 20000)));
    run.object.setHops (5);
    EXPECT_FALSE (run ());
    ASSERT_EQ (run.object.getReport ().surface.components.size (), 1U);
    EXPECT_EQ (run.object.getReport ().surface.boundary_loops, loops);
    const pcl::manifold::SurfaceTopology topology = topologyOf (run.polygons);
    EXPECT_TRUE (topology.isManifold ());
    EXPECT_EQ (topology.boundary_loops, loops);
  }
}

TEST (GraphReconstruction, DoesNotDependOnThreadsOrOrder)
{
  const std::vector<Eigen::Vector3f> points = evenly ("torus", 10000);
  const std::vector<int> order = permutation (points.size ());
  for (const bool triangulate : {true, false}) {
    Reconstruction runs[3];
    for (int i = 0; i < 3; ++i) {
      runs[i].object.setInputCloud (cloudOf (i < 2 ? points : shuffledBy (order, points)));
      runs[i].object.setNumberOfThreads (i == 0 ? 1 : 2);
      runs[i].object.setTriangulate (triangulate);
      EXPECT_FALSE (runs[i]());
    }
    // Polygon by polygon in the same order, and from the same vertex on.
    ASSERT_EQ (runs[0].polygons.size (), runs[1].polygons.size ());
    ASSERT_EQ (runs[0].polygons.size (), runs[2].polygons.size ());
    for (std::size_t i = 0; i < runs[0].polygons.size (); ++i) {
      EXPECT_EQ (runs[0].polygons[i].vertices, runs[1].polygons[i].vertices);
      pcl::Indices renumbered = runs[2].polygons[i].vertices;
      for (pcl::index_t& vertex : renumbered)
        vertex = order[static_cast<std::size_t> (vertex)];
      EXPECT_EQ (runs[0].polygons[i].vertices, renumbered);
    }
    const std::vector<pcl::index_t> tiles = runs[0].object.getTiles ();
    EXPECT_EQ (tiles, runs[1].object.getTiles ());
    const std::vector<pcl::index_t> of_shuffled = runs[2].object.getTiles ();
    for (std::size_t i = 0; i < order.size (); ++i)
      ASSERT_EQ (of_shuffled[i], tiles[static_cast<std::size_t> (order[i])]);
  }
}

TEST (GraphReconstruction, TheSeedChoosesTheLandmarks)
{
  Reconstruction run;
  run.object.setInputCloud (cloudOf (evenly ("torus", 10000)));
  std::set<pcl::Indices> landmarks;
  for (const std::uint64_t seed : {1, 2, 3}) {
    run.object.setSeed (seed);
    EXPECT_FALSE (run ());
    landmarks.insert (run.object.getLandmarks ());
  }
  EXPECT_EQ (landmarks.size (), 3U);
}

TEST (GraphReconstruction, EveryPointHasTheNumberOfALandmark)
{
  std::vector<Eigen::Vector3f> points = evenly ("torus", 5000);
  const std::size_t distinct = points.size ();
  for (std::size_t i = 0; i < distinct; i += 3)
    points.push_back (points[i]);
  const std::size_t finite = points.size ();
  points.insert (points.end (), 10, Eigen::Vector3f (0.0f, NOT_A_NUMBER, 0.0f));
  Reconstruction run;
  run.object.setInputCloud (cloudOf (points));
  EXPECT_FALSE (run ());
  const pcl::Indices landmarks = run.object.getLandmarks ();
  const std::vector<pcl::index_t> tiles = run.object.getTiles ();
  ASSERT_EQ (tiles.size (), points.size ());
  for (std::size_t i = 0; i < landmarks.size (); ++i) {
    ASSERT_LT (static_cast<std::size_t> (landmarks[i]), distinct) << "a duplicate is no landmark";
    EXPECT_EQ (tiles[static_cast<std::size_t> (landmarks[i])], static_cast<pcl::index_t> (i));
  }
  for (std::size_t i = 0; i < finite; ++i) {
    ASSERT_GE (tiles[i], 0);
    ASSERT_LT (static_cast<std::size_t> (tiles[i]), landmarks.size ());
  }
  for (std::size_t i = distinct; i < finite; ++i)
    EXPECT_EQ (tiles[i], tiles[3 * (i - distinct)]);
  for (std::size_t i = finite; i < points.size (); ++i)
    EXPECT_EQ (tiles[i], -1);
  EXPECT_EQ (run.object.getVertices ().size (), distinct);
}

TEST (GraphReconstruction, MoreDuplicatesThanNeighborsChangeNothing)
{
  const std::vector<Eigen::Vector3f> once = evenly ("torus", 3000);
  std::vector<Eigen::Vector3f> often = once;
  for (int i = 0; i < 20; ++i)
    often.insert (often.end (), once.begin (), once.end ());
  Reconstruction runs[2];
  runs[0].object.setInputCloud (cloudOf (once));
  runs[1].object.setInputCloud (cloudOf (often));
  EXPECT_FALSE (runs[0]());
  EXPECT_FALSE (runs[1]());
  EXPECT_EQ (faces (runs[0].polygons), faces (runs[1].polygons));
}

TEST (GraphReconstruction, IndicesAreThoseOfTheWholeCloud)
{
  const std::vector<Eigen::Vector3f> torus = evenly ("torus", 3000);
  std::vector<Eigen::Vector3f> points (300, Eigen::Vector3f (NOT_A_NUMBER, 0.0f, 0.0f));
  points.insert (points.end (), torus.begin (), torus.end ());
  const auto indices = std::make_shared<pcl::Indices> ();
  for (std::size_t i = 300; i < points.size (); ++i)
    indices->push_back (static_cast<pcl::index_t> (i));
  Reconstruction part;
  part.object.setInputCloud (cloudOf (points));
  part.object.setIndices (indices);
  EXPECT_FALSE (part ());
  Reconstruction whole;
  whole.object.setInputCloud (cloudOf (torus));
  EXPECT_FALSE (whole ());
  std::vector<int> back (points.size (), -1);
  for (std::size_t i = 0; i < torus.size (); ++i)
    back[i + 300] = static_cast<int> (i);
  EXPECT_EQ (faces (part.polygons, back), faces (whole.polygons));
  EXPECT_EQ (part.object.getTiles (), whole.object.getTiles ());
}

} // namespace
