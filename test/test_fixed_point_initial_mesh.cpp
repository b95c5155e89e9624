// The public class, started from a mesh.
#include "test_fixed_point_runs.h"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>

namespace {

using namespace fixed_point_runs;

TEST (InitialMesh, OfFewPointsLeadsToOneOverAll)
{
  const std::vector<Eigen::Vector3f> points = torusPoints ();
  const auto run = reconstruct (points, coarseTorus ());
  EXPECT_GE (run->object.getIterations (), 1);
  EXPECT_LE (run->object.getIterations (), 8);
  expectTorus (run->surface, points.size ());
  EXPECT_EQ (sorted (run->object.getComplex ().triangles), sorted (run->surface.triangles));
  const pcl::manifold::FixedPointCounts counts = run->object.getCounts ();
  EXPECT_EQ (counts.anchored + counts.medial + counts.chained, 0U);
}

TEST (InitialMesh, AFixedPointLeadsToItself)
{
  const std::vector<Eigen::Vector3f> points = torusPoints ();
  const auto first = reconstruct (points, coarseTorus ());
  const auto again = reconstruct (points, meshOf (points, first->surface.triangles));
  EXPECT_EQ (sorted (again->surface.triangles), sorted (first->surface.triangles));
  EXPECT_EQ (again->object.getIterations (), 1);
}

// Near the surface all fixed points are in the manifold fixed-point complex.
TEST (InitialMesh, LeadsIntoTheManifoldFixedPointComplex)
{
  const std::vector<Eigen::Vector3f> points = torusPoints (0.05);
  const auto run = reconstruct (points, coarseTorus ());
  const std::set<Triangle> complex = sorted (reconstruct (points)->object.getComplex ().triangles);
  for (const Triangle& triangle : sorted (run->surface.triangles))
    EXPECT_EQ (complex.count (triangle), 1U);
}

void
expectRefused (const pcl::PolygonMesh& mesh)
{
  Reconstruction run;
  run.object.setInputCloud (cloudOf (torusPoints ()));
  run.object.setInitialMesh (std::make_shared<pcl::PolygonMesh> (mesh));
  expectFailure (run, Status::PARAMETER_OUT_OF_RANGE);
  run.object.setInitialMesh (nullptr);
  EXPECT_FALSE (run ());
  EXPECT_EQ (run.object.getStatus (), Status::OK);
}

TEST (InitialMesh, IsRefusedWhereItIsNone)
{
  const pcl::PolygonMesh good = *coarseTorus ();
  const auto with = [&good] (auto change) {
    pcl::PolygonMesh mesh = good;
    change (mesh);
    return mesh;
  };
  expectRefused (pcl::PolygonMesh ());
  expectRefused (with ([] (auto& mesh) { mesh.polygons.clear (); }));
  expectRefused (with ([] (auto& mesh) { mesh.polygons.assign (3, pcl::Vertices ()); }));
  expectRefused (with ([] (auto& mesh) {
    mesh.polygons.resize (1);
    mesh.polygons[0].vertices = {0, 1};
  }));
  for (const pcl::index_t wrong : {-1, 100000, std::numeric_limits<pcl::index_t>::max ()})
    expectRefused (with ([wrong] (auto& mesh) { mesh.polygons[5].vertices[1] = wrong; }));
  expectRefused (with ([] (auto& mesh) { mesh.cloud = pcl::PCLPointCloud2 (); }));
  expectRefused (with ([] (auto& mesh) { mesh.cloud.data.resize (100); }));
  expectRefused (with ([] (auto& mesh) { mesh.cloud.fields[2].name = "w"; }));
  expectRefused (with ([] (auto& mesh) { mesh.cloud.fields[1].offset = 1000; }));
  expectRefused (with ([] (auto& mesh) { mesh.cloud.fields[1].datatype = pcl::PCLPointField::INT32; }));
  for (const float wrong : {NOT_A_NUMBER, std::numeric_limits<float>::infinity ()})
    expectRefused (with ([wrong] (auto& mesh) {
      const auto vertex = static_cast<std::size_t> (mesh.polygons[5].vertices[1]);
      std::memcpy (&mesh.cloud.data[vertex * mesh.cloud.point_step], &wrong, sizeof (wrong));
    }));
}

TEST (InitialMesh, MayHavePointsThatNoFaceHas)
{
  const pcl::PolygonMesh::Ptr mesh = coarseTorus ();
  pcl::PointCloud<pcl::PointXYZ> cloud;
  pcl::fromPCLPointCloud2 (mesh->cloud, cloud);
  cloud.push_back (pcl::PointXYZ (NOT_A_NUMBER, 0.0f, 0.0f));
  cloud.push_back (pcl::PointXYZ (7.0f, 7.0f, 7.0f));
  pcl::toPCLPointCloud2 (cloud, mesh->cloud);
  mesh->polygons.emplace_back ();
  mesh->polygons.back ().vertices = {0, static_cast<pcl::index_t> (cloud.size ()) - 2};
  EXPECT_EQ (reconstruct (torusPoints (), mesh)->surface.triangles,
             reconstruct (torusPoints (), coarseTorus ())->surface.triangles);
}

TEST (InitialMesh, MayHaveLargerFacesAndDoubles)
{
  // The unit square, coarser than the grid that lies in it.
  std::vector<Eigen::Vector3f> points;
  for (const Eigen::Vector3f& point : grid (9, 9, 1))
    points.push_back (point / 8.0f);
  const pcl::PolygonMesh::Ptr square = meshOf ({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {});
  square->polygons.emplace_back ();
  square->polygons.back ().vertices = {0, 1, 2, 3};
  const auto run = reconstruct (points, square);
  EXPECT_EQ (run->surface.triangles.size (), 128U);

  pcl::PolygonMesh::Ptr doubles = std::make_shared<pcl::PolygonMesh> (*square);
  doubles->cloud.point_step = 32;
  doubles->cloud.row_step = 4 * 32;
  doubles->cloud.data.assign (4 * 32, 0);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    doubles->cloud.fields[axis].offset = static_cast<pcl::uindex_t> (8 * axis);
    doubles->cloud.fields[axis].datatype = pcl::PCLPointField::FLOAT64;
  }
  const double one = 1.0;
  for (const std::size_t offset : {32, 64, 72, 104})
    std::memcpy (&doubles->cloud.data[offset], &one, sizeof (one));
  EXPECT_EQ (reconstruct (points, doubles)->surface.triangles, run->surface.triangles);
}

// Nothing to be found is no failure.
TEST (InitialMesh, WithinOneVoronoiCellLeadsToNothing)
{
  const std::vector<Eigen::Vector3f> points = torusPoints ();
  const Eigen::Vector3f at = points.front ();
  const auto run =
    reconstruct (points, meshOf ({at, at + Eigen::Vector3f (1e-4f, 0, 0), at + Eigen::Vector3f (0, 1e-4f, 0)},
                                 {{0, 1, 2}}));
  EXPECT_TRUE (run->surface.empty ());
  EXPECT_TRUE (run->object.getComplex ().empty ());
}

TEST (InitialMesh, SurvivesDegenerateClouds)
{
  const pcl::PolygonMesh::Ptr mesh = coarseTorus ();
  for (const Named& named : degenerateClouds ()) {
    SCOPED_TRACE (named.name);
    Reconstruction run;
    run.object.setInputCloud (cloudOf (named.points));
    run.object.setInitialMesh (mesh);
    run ();
    EXPECT_NE (run.object.getStatus (), Status::INTERNAL_ERROR);
    EXPECT_TRUE (run.surface.empty () || run.object.getStatus () == Status::OK);
    EXPECT_TRUE (pcl::manifold::isValid (run.surface, named.points.size ()));
  }
}

} // namespace
