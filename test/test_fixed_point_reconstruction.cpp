// The public class: what it does with every kind of input, and that nothing but the points decides the
// result.
#include "test_class_point_type.h"
#include "test_fixed_point_runs.h"

#include <gtest/gtest.h>

namespace {

using namespace fixed_point_runs;

TEST (FixedPointReconstruction, SaysWhatIsWrongWithTheInput)
{
  checkInputs<Reconstruction> ();
  checkInputs<MeshReconstruction> ();
  checkInputs<InitialMeshReconstruction> ();
}

TEST (FixedPointReconstruction, SaysWhatIsWrongWithTheIndices)
{
  checkIndices<Reconstruction> ();
  checkIndices<MeshReconstruction> ();
}

TEST (FixedPointReconstruction, CanBeCancelledAtEveryStage)
{
  checkProgress<Reconstruction> ();
  checkProgress<MeshReconstruction> ();
  checkProgress<InitialMeshReconstruction> ();
  checkStatusDuringRun<MeshReconstruction> ();
}

TEST (FixedPointReconstruction, KeepsTheLayoutOfAnOrganizedCloud)
{
  checkLayoutOfMesh<MeshReconstruction> ();
}

TEST (FixedPointReconstruction, NamesASearchThatIsNotUsedOnce)
{
  checkNeedlessSearch<MeshReconstruction> ();
}

TEST (FixedPointReconstruction, RefusesParametersOutOfRange)
{
  checkThinning<Reconstruction> ();
  for (const double ratio : {0.0, -0.313, std::nan ("")}) {
    Reconstruction run;
    run.object.setInputCloud (cloudOf (torusPoints ()));
    run.object.setCriticalRatio (ratio);
    expectFailure (run, Status::PARAMETER_OUT_OF_RANGE);
    run.object.setCriticalRatio (0.5);
    EXPECT_FALSE (run ());
  }
  for (const int votes : {0, -1, 4}) {
    Reconstruction run;
    run.object.setInputCloud (cloudOf (torusPoints ()));
    run.object.setVotes (votes);
    expectFailure (run, Status::PARAMETER_OUT_OF_RANGE);
    run.object.setVotes (3);
    EXPECT_FALSE (run ());
  }
}

TEST (FixedPointReconstruction, RemembersItsParameters)
{
  pcl::FixedPointReconstruction<pcl::PointXYZ> object;
  EXPECT_EQ (object.getCriticalRatio (), 0.8);
  EXPECT_EQ (object.getVotes (), 3);
  EXPECT_EQ (object.getThinningNeighbors (), 0);
  EXPECT_EQ (object.getThinningDistance (), 0.0);
  EXPECT_EQ (object.getNumberOfThreads (), 0U);
  EXPECT_FALSE (object.getWatertight ());
  EXPECT_EQ (object.getInitialMesh (), nullptr);
  EXPECT_EQ (object.getStatus (), Status::NOT_COMPUTED);
  EXPECT_TRUE (givesNothing (object));
  object.setCriticalRatio (0.313);
  object.setVotes (1);
  object.setThinningNeighbors (4);
  object.setThinningDistance (0.25);
  object.setNumberOfThreads (2);
  object.setWatertight (true);
  const auto mesh = std::make_shared<pcl::PolygonMesh> ();
  object.setInitialMesh (mesh);
  EXPECT_EQ (object.getCriticalRatio (), 0.313);
  EXPECT_EQ (object.getVotes (), 1);
  EXPECT_EQ (object.getThinningNeighbors (), 4);
  EXPECT_EQ (object.getThinningDistance (), 0.25);
  EXPECT_EQ (object.getNumberOfThreads (), 2U);
  EXPECT_TRUE (object.getWatertight ());
  EXPECT_EQ (object.getInitialMesh (), mesh);
}

TEST (FixedPointReconstruction, SurvivesDegenerateClouds)
{
  for (const bool watertight : {false, true})
    for (const Named& named : degenerateClouds ()) {
      SCOPED_TRACE (named.name);
      Reconstruction run;
      run.object.setWatertight (watertight);
      run.object.setInputCloud (cloudOf (named.points));
      // A surface may be empty although all went well: isolated points have none.
      const bool empty = run ();
      EXPECT_TRUE (empty || run.object.getStatus () == Status::OK);
      EXPECT_NE (run.object.getStatus (), Status::INTERNAL_ERROR);
      EXPECT_TRUE (pcl::manifold::isValid (run.surface, named.points.size ()));
      EXPECT_TRUE (pcl::manifold::analyze (run.surface).surface.isManifold ());
      for (const Triangle& triangle : run.surface.triangles)
        for (const pcl::index_t vertex : triangle)
          EXPECT_TRUE (named.points[static_cast<std::size_t> (vertex)].allFinite ());
    }
}

TEST (FixedPointReconstruction, SaysThatPointsSpanNoTriangle)
{
  for (int n = 1; n <= 4; ++n) {
    Reconstruction run;
    run.object.setInputCloud (cloudOf (grid (n, 1, 1)));
    expectFailure (run, n < 3 ? Status::TOO_FEW_POINTS : Status::DIMENSION_TOO_LOW);
  }
}

TEST (FixedPointReconstruction, ThreeAndFourPointsAreAFewTriangles)
{
  EXPECT_EQ (reconstruct ({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}})->surface.triangles.size (), 1U);
  EXPECT_EQ (reconstruct ({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}})->surface.triangles.size (), 2U);
}

TEST (FixedPointReconstruction, SaysThatACurveIsNoSurface)
{
  std::vector<Eigen::Vector3f> helix;
  for (int i = 0; i < 300; ++i) {
    const float turn = 0.05f * static_cast<float> (i);
    helix.emplace_back (std::cos (turn), std::sin (turn), 0.5f * turn);
  }
  Reconstruction run;
  run.object.setInputCloud (cloudOf (helix));
  expectFailure (run, Status::DIMENSION_TOO_LOW);
}

// Points that are seven times as near to each other along the lines of a scanner as across them: their
// Voronoi cells are like those of points on curves.
TEST (FixedPointReconstruction, LinesOfAScannerAreASurface)
{
  std::vector<Eigen::Vector3f> points;
  for (int line = 0; line < 40; ++line)
    for (int i = 0; i < 300; ++i) {
      const double a = 2.0 * M_PI * line / 40;
      const double b = 2.0 * M_PI * (i + 0.37 * line) / 300;
      const double out = 1.0 + 0.5 * std::cos (b);
      points.emplace_back (
        Eigen::Vector3d (out * std::cos (a), out * std::sin (a), 0.5 * std::sin (b)).cast<float> ());
    }
  for (const bool watertight : {false, true}) {
    Reconstruction run;
    run.object.setInputCloud (cloudOf (points));
    run.object.setWatertight (watertight);
    EXPECT_FALSE (run ());
    expectTorus (run.surface, points.size ());
  }
}

TEST (FixedPointReconstruction, AFlatGridIsOneSheet)
{
  const auto run = reconstruct (grid (12, 9, 1));
  const pcl::manifold::SurfaceTopology topology = pcl::manifold::analyze (run->surface).surface;
  EXPECT_EQ (topology.vertices, 12U * 9);
  EXPECT_EQ (topology.faces, 2U * 11 * 8);
  EXPECT_TRUE (topology.isManifold ());
  EXPECT_EQ (topology.boundary_loops, 1U);
}

TEST (FixedPointReconstruction, ATorusIsATorus)
{
  const std::vector<Eigen::Vector3f> points = torusPoints ();
  const auto run = reconstruct (points);
  expectTorus (run->surface, points.size ());
  EXPECT_EQ (run->object.getIterations (), 0);

  const pcl::manifold::FixedPointCounts counts = run->object.getCounts ();
  EXPECT_GT (counts.medial, 0U);
  EXPECT_GT (counts.chained, 0U);
  EXPECT_GT (counts.anchored, counts.medial);
  const std::set<Triangle> complex = sorted (run->object.getComplex ().triangles);
  EXPECT_EQ (complex.size (), counts.anchored - counts.medial + counts.chained);
  for (const Triangle& triangle : sorted (run->surface.triangles))
    EXPECT_EQ (complex.count (triangle), 1U);
}

TEST (FixedPointReconstruction, AllReconstructionsGiveTheSameTriangles)
{
  const auto cloud = cloudOf (torusPoints ());
  cloud->header.frame_id = "map";
  cloud->header.stamp = 77;
  MeshReconstruction mesh;
  mesh.object.setInputCloud (cloud);
  EXPECT_FALSE (mesh ());
  EXPECT_EQ (mesh.mesh.header.frame_id, "map");
  EXPECT_EQ (mesh.mesh.header.stamp, 77U);
  EXPECT_EQ (static_cast<std::size_t> (mesh.mesh.cloud.width) * mesh.mesh.cloud.height, cloud->size ());

  const auto run = reconstruct (torusPoints ());
  pcl::FixedPointReconstruction<pcl::PointXYZ> object;
  object.setInputCloud (cloud);
  std::vector<pcl::Vertices> polygons (5);
  static_cast<pcl::MeshConstruction<pcl::PointXYZ>&> (object).reconstruct (polygons);
  ASSERT_EQ (polygons.size (), mesh.mesh.polygons.size ());
  ASSERT_EQ (polygons.size (), run->surface.triangles.size ());
  for (std::size_t i = 0; i < polygons.size (); ++i) {
    EXPECT_EQ (polygons[i].vertices, mesh.mesh.polygons[i].vertices);
    EXPECT_TRUE (std::equal (polygons[i].vertices.begin (), polygons[i].vertices.end (),
                             run->surface.triangles[i].begin (), run->surface.triangles[i].end ()));
  }
  object.setVotes (0);
  static_cast<pcl::MeshConstruction<pcl::PointXYZ>&> (object).reconstruct (polygons);
  EXPECT_TRUE (polygons.empty ());
}

TEST (FixedPointReconstruction, IndicesAreThoseOfTheWholeCloud)
{
  const std::vector<Eigen::Vector3f> torus = torusPoints ();
  std::vector<Eigen::Vector3f> points (300, Eigen::Vector3f (NOT_A_NUMBER, 0.0f, 0.0f));
  points.insert (points.end (), torus.begin (), torus.end ());
  const auto indices = std::make_shared<pcl::Indices> ();
  for (std::size_t i = 300; i < points.size (); ++i)
    indices->push_back (static_cast<pcl::index_t> (i));
  Reconstruction run;
  run.object.setInputCloud (cloudOf (points));
  run.object.setIndices (indices);
  EXPECT_FALSE (run ());
  std::vector<int> back (points.size (), -1);
  for (std::size_t i = 0; i < torus.size (); ++i)
    back[i + 300] = static_cast<int> (i);
  const auto alone = reconstruct (torus);
  EXPECT_EQ (sorted (run.surface.triangles, back), sorted (alone->surface.triangles));
  EXPECT_EQ (sorted (run.object.getComplex ().triangles, back),
             sorted (alone->object.getComplex ().triangles));
}

TEST (FixedPointReconstruction, DoesNotDependOnThreadsOrOrder)
{
  const std::vector<Eigen::Vector3f> points = torusAndKnot ();
  const std::vector<int> order = permutation (points.size ());
  std::vector<Eigen::Vector3f> shuffled;
  for (const int i : order)
    shuffled.push_back (points[static_cast<std::size_t> (i)]);
  for (const pcl::PolygonMesh::ConstPtr& initial :
       {pcl::PolygonMesh::ConstPtr (), pcl::PolygonMesh::ConstPtr (coarseTorus ())})
    for (const int k : {0, 4}) {
      const auto one = reconstruct (points, initial, 1, k);
      const auto two = reconstruct (points, initial, 2, k);
      const auto other = reconstruct (shuffled, initial, 2, k);
      EXPECT_EQ (one->surface.triangles, two->surface.triangles);
      EXPECT_EQ (one->object.getComplex ().triangles, two->object.getComplex ().triangles);
      // Triangle by triangle in the same order, and with the same directions.
      ASSERT_EQ (one->surface.triangles.size (), other->surface.triangles.size ());
      for (std::size_t i = 0; i < one->surface.triangles.size (); ++i)
        for (std::size_t j = 0; j < 3; ++j)
          ASSERT_EQ (order[static_cast<std::size_t> (other->surface.triangles[i][j])],
                     one->surface.triangles[i][j]);
      EXPECT_EQ (sorted (other->object.getComplex ().triangles, order),
                 sorted (one->object.getComplex ().triangles));
    }
}

TEST (FixedPointReconstruction, SharesTheTriangulationOfTheSameCloudOnly)
{
  const auto first = reconstruct (torusPoints ());
  Reconstruction run;
  run.object.setInputCloud (cloudOf (torusPoints ()));
  run.object.setDelaunayComplex (first->object.getDelaunayComplex ());
  EXPECT_FALSE (run ());
  EXPECT_EQ (run.object.getDelaunayComplex (), first->object.getDelaunayComplex ());
  EXPECT_EQ (run.surface.triangles, first->surface.triangles);

  run.object.setInputCloud (cloudOf (torusPoints (0.09, 2)));
  EXPECT_FALSE (run ());
  EXPECT_NE (run.object.getDelaunayComplex (), first->object.getDelaunayComplex ());
  EXPECT_EQ (run.surface.triangles, reconstruct (torusPoints (0.09, 2))->surface.triangles);
}

TEST (FixedPointReconstruction, OneObjectServesSeveralClouds)
{
  Reconstruction run;
  for (const std::uint64_t seed : {1, 2, 1}) {
    run.object.setInputCloud (cloudOf (torusPoints (0.09, seed)));
    EXPECT_FALSE (run ());
    EXPECT_EQ (run.surface.triangles, reconstruct (torusPoints (0.09, seed))->surface.triangles);
  }
}

TEST (FixedPointReconstruction, WatertightIsClosed)
{
  const std::vector<Eigen::Vector3f> points =
    floats (generate::blueNoise (generate::shapeByName ("hemisphere"), 0.09, 1));
  EXPECT_EQ (pcl::manifold::analyze (reconstruct (points)->surface).surface.boundary_loops, 1U);
  Reconstruction run;
  run.object.setInputCloud (cloudOf (points));
  run.object.setWatertight (true);
  EXPECT_FALSE (run ());
  const pcl::manifold::SurfaceTopology topology = pcl::manifold::analyze (run.surface).surface;
  EXPECT_TRUE (topology.isManifold ());
  EXPECT_TRUE (topology.isClosed ());
}

TEST (FixedPointReconstruction, TakesAPointTypeOfTheUsersOwn)
{
  const auto cloud = cloudOf<SurveyPoint> (torusPoints ());
  (*cloud)[7].reflectance = 0.25f;
  pcl::FixedPointReconstruction<SurveyPoint> object;
  object.setInputCloud (cloud);
  pcl::PolygonMesh mesh;
  object.reconstruct (mesh);
  EXPECT_EQ (object.getStatus (), Status::OK);
  EXPECT_EQ (mesh.polygons.size (), reconstruct (torusPoints ())->surface.triangles.size ());
  pcl::PointCloud<SurveyPoint> back;
  pcl::fromPCLPointCloud2 (mesh.cloud, back);
  ASSERT_EQ (back.size (), cloud->size ());
  EXPECT_EQ (back[7].reflectance, 0.25f);
}

} // namespace
