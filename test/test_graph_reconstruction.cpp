// The public class: what it does with every kind of input.
#include "test_graph_runs.h"

#include <gtest/gtest.h>

namespace {

using namespace graph_runs;
using pcl::manifold::AdjacencyRule;
using pcl::manifold::FaceRule;

TEST (GraphReconstruction, SaysWhatIsWrongWithTheInput)
{
  checkInputs<Reconstruction> ();
  checkInputs<MeshReconstruction> ();
}

TEST (GraphReconstruction, SaysWhatIsWrongWithTheIndices)
{
  checkIndices<Reconstruction> ();
  checkIndices<MeshReconstruction> ();
}

TEST (GraphReconstruction, CanBeCancelledAtEveryStage)
{
  checkProgress<Reconstruction> ();
  checkProgress<MeshReconstruction> ();
  checkStatusDuringRun<MeshReconstruction> ();
}

TEST (GraphReconstruction, KeepsTheLayoutOfAnOrganizedCloud)
{
  checkLayoutOfMesh<MeshReconstruction> ();
}

TEST (GraphReconstruction, HasTheDefaultsOfThePaper)
{
  const pcl::GraphReconstruction<pcl::PointXYZ> object;
  EXPECT_EQ (object.getKSearch (), 15);
  EXPECT_EQ (object.getHops (), 5);
  EXPECT_TRUE (object.getRefine ());
  EXPECT_EQ (object.getAdjacencyThreshold (), 7);
  EXPECT_EQ (object.getAdjacencyRule (), AdjacencyRule::BOUNDARY_POINTS);
  EXPECT_EQ (object.getFaceRule (), FaceRule::ROTATION_SYSTEM);
  EXPECT_TRUE (object.getTriangulate ());
  EXPECT_EQ (object.getStatus (), Status::NOT_COMPUTED);
  EXPECT_TRUE (givesNothing (object));
}

template <typename Set>
void
expectRefused (const Set& set)
{
  Reconstruction run;
  run.object.setInputCloud (cloudOf (torusAndKnot ()));
  set (run.object);
  expectFailure (run, Status::PARAMETER_OUT_OF_RANGE);
}

TEST (GraphReconstruction, RefusesParametersOutOfRange)
{
  for (const int k : {0, -1, -1000}) {
    expectRefused ([k] (auto& object) { object.setKSearch (k); });
    expectRefused ([k] (auto& object) { object.setHops (k); });
  }
  expectRefused ([] (auto& object) { object.setAdjacencyThreshold (-1); });
  expectRefused ([] (auto& object) { object.setMaximumFaceLength (2); });
}

TEST (GraphReconstruction, RemembersItsParameters)
{
  Reconstruction run;
  run.object.setInputCloud (cloudOf (torusAndKnot ()));
  run.object.setKSearch (0);
  EXPECT_TRUE (run ());
  run.object.setKSearch (12);
  run.object.setHops (4);
  run.object.setRefine (false);
  run.object.setAdjacencyThreshold (5);
  run.object.setAdjacencyRule (AdjacencyRule::LINKING_EDGES);
  run.object.setFaceRule (FaceRule::SHORTEST_CYCLES);
  run.object.setMaximumFaceLength (6);
  run.object.setTriangulate (false);
  run.object.setSeed (77);
  run.object.setNumberOfThreads (2);
  EXPECT_FALSE (run ());
  EXPECT_EQ (run.object.getStatus (), Status::OK);
  EXPECT_EQ (run.object.getKSearch (), 12);
  EXPECT_EQ (run.object.getHops (), 4);
  EXPECT_FALSE (run.object.getRefine ());
  EXPECT_EQ (run.object.getAdjacencyThreshold (), 5);
  EXPECT_EQ (run.object.getAdjacencyRule (), AdjacencyRule::LINKING_EDGES);
  EXPECT_EQ (run.object.getFaceRule (), FaceRule::SHORTEST_CYCLES);
  EXPECT_EQ (run.object.getMaximumFaceLength (), 6);
  EXPECT_FALSE (run.object.getTriangulate ());
  EXPECT_EQ (run.object.getSeed (), 77U);
  EXPECT_EQ (run.object.getNumberOfThreads (), 2U);
}

TEST (GraphReconstruction, NeedsThreeDistinctPoints)
{
  const std::vector<Eigen::Vector3f> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (std::size_t n = 1; n <= 4; ++n) {
    // Every point four times over.
    std::vector<Eigen::Vector3f> cloud;
    for (std::size_t i = 0; i < 4 * n; ++i)
      cloud.push_back (points[i % n]);
    for (const int hops : {1, 2, 5}) {
      SCOPED_TRACE (std::to_string (n) + " points, hops " + std::to_string (hops));
      MeshReconstruction run;
      run.object.setInputCloud (cloudOf (cloud));
      run.object.setHops (hops);
      if (n < 3) {
        expectFailure (run, Status::TOO_FEW_POINTS);
        continue;
      }
      // Too few to make tiles that touch enough.
      run ();
      EXPECT_EQ (run.object.getStatus (), Status::DIMENSION_TOO_LOW);
      EXPECT_TRUE (run.mesh.polygons.empty ());
      EXPECT_EQ (run.object.getLandmarks ().size (), hops == 1 ? n : 1);
    }
  }
}

TEST (GraphReconstruction, SurvivesDegenerateClouds)
{
  for (const FaceRule rule : {FaceRule::ROTATION_SYSTEM, FaceRule::SHORTEST_CYCLES})
    for (const Named& named : degenerateClouds ())
      for (const int hops : {1, 2, 3})
        for (const int k : {1, 6, 1000}) {
          SCOPED_TRACE (named.name + ", hops " + std::to_string (hops) + ", k " + std::to_string (k));
          if (k > 100 && named.points.size () > 500)
            continue; // complete graphs take their time
          MeshReconstruction run;
          run.object.setInputCloud (cloudOf (named.points));
          run.object.setFaceRule (rule);
          run.object.setHops (hops);
          run.object.setKSearch (k);
          run.object.setAdjacencyThreshold (0);
          run ();
          EXPECT_EQ (run.mesh.polygons.empty (), run.object.getStatus () != Status::OK);
          EXPECT_EQ (run.mesh.cloud.data.empty (), run.object.getStatus () != Status::OK);
          EXPECT_NE (run.object.getStatus (), Status::INTERNAL_ERROR);
          for (const pcl::Vertices& polygon : run.mesh.polygons)
            for (const pcl::index_t vertex : polygon.vertices) {
              ASSERT_GE (vertex, 0);
              ASSERT_LT (static_cast<std::size_t> (vertex), named.points.size ());
              EXPECT_TRUE (named.points[static_cast<std::size_t> (vertex)].allFinite ());
            }
        }
}

TEST (GraphReconstruction, HopsFromOneToBeyondTheDiameter)
{
  const std::vector<Eigen::Vector3f> sphere = evenly ("sphere", 3000);
  Reconstruction run;
  run.object.setInputCloud (cloudOf (sphere));
  run.object.setHops (1);
  run ();
  EXPECT_EQ (run.object.getLandmarks ().size (), sphere.size ());
  run.object.setHops (1000);
  run.object.setRefine (false);
  run ();
  EXPECT_EQ (run.object.getStatus (), Status::DIMENSION_TOO_LOW);
  EXPECT_TRUE (run.polygons.empty ());
  // What was found on the way is there.
  EXPECT_EQ (run.object.getLandmarks ().size (), 1U);
  EXPECT_EQ (run.object.getTiles (), std::vector<pcl::index_t> (sphere.size (), 0));
  EXPECT_EQ (run.object.getReport ().surface.faces, 0U);
}

TEST (GraphReconstruction, KOfAllPointsOrMoreJoinsAll)
{
  const std::vector<Eigen::Vector3f> points = evenly ("sphere", 300);
  const auto n = static_cast<int> (points.size ());
  for (const int k : {n - 1, n, n + 1, 1000000000}) {
    Reconstruction run;
    run.object.setInputCloud (cloudOf (points));
    run.object.setKSearch (k);
    run ();
    EXPECT_EQ (run.object.getStatus (), Status::DIMENSION_TOO_LOW);
    EXPECT_EQ (run.object.getNeighborhoodGraph ().neighbors.size (), points.size () * (points.size () - 1));
  }
}

TEST (GraphReconstruction, PointsAlongACurveHaveNoFace)
{
  MeshReconstruction run;
  run.object.setInputCloud (cloudOf (grid (500, 1, 1)));
  run ();
  EXPECT_EQ (run.object.getStatus (), Status::DIMENSION_TOO_LOW);
  EXPECT_TRUE (run.mesh.polygons.empty ());
  EXPECT_TRUE (run.mesh.cloud.data.empty ());
}

TEST (GraphReconstruction, BothReconstructionsOfTheBaseClassGiveTheSamePolygons)
{
  MeshReconstruction mesh;
  const auto cloud = cloudOf (torusAndKnot ());
  cloud->header.frame_id = "map";
  cloud->header.stamp = 77;
  mesh.object.setInputCloud (cloud);
  EXPECT_FALSE (mesh ());
  EXPECT_EQ (mesh.mesh.header.frame_id, "map");
  EXPECT_EQ (mesh.mesh.header.stamp, 77U);
  EXPECT_EQ (static_cast<std::size_t> (mesh.mesh.cloud.width) * mesh.mesh.cloud.height, cloud->size ());

  std::vector<pcl::Vertices> polygons (5);
  static_cast<pcl::MeshConstruction<pcl::PointXYZ>&> (mesh.object).reconstruct (polygons);
  ASSERT_EQ (polygons.size (), mesh.mesh.polygons.size ());
  for (std::size_t i = 0; i < polygons.size (); ++i)
    EXPECT_EQ (polygons[i].vertices, mesh.mesh.polygons[i].vertices);
  mesh.object.setHops (0);
  static_cast<pcl::MeshConstruction<pcl::PointXYZ>&> (mesh.object).reconstruct (polygons);
  EXPECT_TRUE (polygons.empty ());
}

TEST (GraphReconstruction, OneObjectServesSeveralClouds)
{
  Reconstruction run;
  for (const std::uint64_t seed : {1, 2, 1}) {
    run.object.setInputCloud (cloudOf (torusAndKnot (seed)));
    EXPECT_FALSE (run ());
    Reconstruction alone;
    alone.object.setInputCloud (cloudOf (torusAndKnot (seed)));
    EXPECT_FALSE (alone ());
    EXPECT_EQ (faces (run.polygons), faces (alone.polygons));
  }
}

} // namespace
