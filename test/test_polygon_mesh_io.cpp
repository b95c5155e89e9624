// Meshes of polygons of any sizes in files, read again by this library, by VTK and by PCL.
#include "test_apps_folder.h"
#include "test_vtk_loader.h"

#include <pcl/manifold/complex_io.h>

#include <gtest/gtest.h>
#include <pcl/conversions.h>
#include <pcl/io/obj_io.h>
#include <pcl/io/ply_io.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <numeric>

namespace {

using pcl::manifold::loadComplex;
using pcl::manifold::savePolygonMesh;

/** Points on a circle. */
pcl::PolygonMesh
meshOf (const std::vector<pcl::Indices>& polygons, std::size_t points)
{
  pcl::PointCloud<pcl::PointXYZ> cloud;
  for (std::size_t i = 0; i < points; ++i) {
    const auto angle = static_cast<float> (i) * 6.2831853f / static_cast<float> (points);
    cloud.push_back (pcl::PointXYZ (std::cos (angle), std::sin (angle), 0.1f * static_cast<float> (i)));
  }
  pcl::PolygonMesh mesh;
  pcl::toPCLPointCloud2 (cloud, mesh.cloud);
  for (const pcl::Indices& vertices : polygons) {
    pcl::Vertices polygon;
    polygon.vertices = vertices;
    mesh.polygons.push_back (polygon);
  }
  return mesh;
}

const std::vector<pcl::Indices> FACES = {{0, 1, 2}, {2, 3, 4, 5}, {5, 6, 7, 8, 0}, {1, 0, 8}};

class PolygonMeshFiles : public testing::TestWithParam<std::string>
{
protected:
  TestFolder folder;
  std::string file = folder / ("mesh" + GetParam ());
  std::string error;

  std::size_t triangles ()
  {
    pcl::PCLPointCloud2 cloud;
    const auto load = GetParam ()[1] == 'v' ? loadByVtk : loadComplex;
    EXPECT_TRUE (load (file, cloud, complex, error)) << error;
    return complex.triangles.size ();
  }

  pcl::SimplicialComplex complex;
};

TEST_P (PolygonMeshFiles, AreReadWithLargerFacesCut)
{
  for (const bool ascii : {false, true}) {
    ASSERT_TRUE (savePolygonMesh (file, meshOf (FACES, 9), error, ascii)) << error;
    EXPECT_EQ (triangles (), 1U + 2U + 3U + 1U);
    EXPECT_EQ (complex.triangles[1], (pcl::SimplicialComplex::Triangle{2, 3, 4}));
    EXPECT_TRUE (complex.edges.empty ());
  }
  EXPECT_EQ (folder.count (), 1);
}

TEST_P (PolygonMeshFiles, HoldPolygonsOfTwoVerticesAsEdges)
{
  ASSERT_TRUE (savePolygonMesh (file, meshOf ({{3, 4}, {0, 1, 2, 3}}, 5), error)) << error;
  EXPECT_EQ (triangles (), 2U);
  EXPECT_EQ (complex.edges, (std::vector<pcl::SimplicialComplex::Edge>{{3, 4}}));
}

TEST_P (PolygonMeshFiles, HoldFacesOfManyVertices)
{
  pcl::Indices all (300);
  std::iota (all.begin (), all.end (), 0);
  ASSERT_TRUE (savePolygonMesh (file, meshOf ({{0, 1, 2}, all}, 300), error)) << error;
  EXPECT_EQ (triangles (), 1U + 298U);
}

TEST_P (PolygonMeshFiles, AreNotWrittenWithWrongPolygons)
{
  for (const auto& [polygon, message] :
       {std::pair<pcl::Indices, std::string>{{1}, "polygon 1 has 1 vertices"},
        {{}, "polygon 1 has 0 vertices"},
        {{0, 1, 9}, "polygon 1 has vertex 9, but there are 9 points"},
        {{-1, 1, 2}, "polygon 1 has vertex -1, but there are 9 points"}}) {
    EXPECT_FALSE (savePolygonMesh (file, meshOf ({{0, 1, 2}, polygon}, 9), error));
    EXPECT_EQ (error, message);
    EXPECT_EQ (folder.count (), 0);
  }
}

INSTANTIATE_TEST_SUITE_P (Formats, PolygonMeshFiles, testing::Values (".ply", ".obj", ".vtk", ".vtu"),
                          [] (const auto& tested) { return tested.param.substr (1); });

void
expectFaces (const pcl::PolygonMesh& mesh)
{
  ASSERT_EQ (mesh.polygons.size (), FACES.size ());
  for (std::size_t i = 0; i < FACES.size (); ++i)
    EXPECT_EQ (mesh.polygons[i].vertices, FACES[i]);
  pcl::PointCloud<pcl::PointXYZ> cloud;
  pcl::fromPCLPointCloud2 (mesh.cloud, cloud);
  ASSERT_EQ (cloud.size (), 9U);
  EXPECT_EQ (cloud[3].z, 0.1f * 3.0f);
}

TEST (PolygonMesh, IsReadByPclAsItWas)
{
  const TestFolder folder;
  std::string error;
  for (const bool ascii : {false, true}) {
    ASSERT_TRUE (savePolygonMesh (folder / "mesh.ply", meshOf (FACES, 9), error, ascii)) << error;
    pcl::PolygonMesh mesh;
    ASSERT_GE (pcl::io::loadPLYFile (folder / "mesh.ply", mesh), 0);
    expectFaces (mesh);
  }
  ASSERT_TRUE (savePolygonMesh (folder / "mesh.obj", meshOf (FACES, 9), error)) << error;
  pcl::PolygonMesh mesh;
  ASSERT_GE (pcl::io::loadOBJFile (folder / "mesh.obj", mesh), 0);
  expectFaces (mesh);
}

TEST (PolygonMesh, IsNotWrittenToAnUnknownFormat)
{
  const TestFolder folder;
  std::string error;
  EXPECT_FALSE (savePolygonMesh (folder / "mesh.stl", meshOf (FACES, 9), error));
  EXPECT_EQ (error, "unknown extension .stl; use .ply, .obj, .vtk or .vtu");
  EXPECT_EQ (folder.count (), 0);
}

} // namespace
