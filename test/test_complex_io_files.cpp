#include "test_apps_folder.h"
#include "test_complex_io_clouds.h"

#include <pcl/manifold/complex_io.h>

#include <pcl/conversions.h>
#include <pcl/io/obj_io.h>
#include <pcl/io/ply_io.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace {

using pcl::manifold::loadComplex;
using pcl::manifold::saveComplex;

/** \brief Loads bytes as a file with the given name. */
struct Loaded
{
  bool good = false;
  PCLPointCloud2 cloud;
  SimplicialComplex complex;
  std::string error;

  Loaded (const std::string& extension, const std::string& bytes)
  {
    const TestFolder folder;
    good = loadComplex (folder.write ("file" + extension, bytes), cloud, complex, error);
  }
};

TEST (ComplexIoFiles, PlyOfOthers)
{
  Loaded file (
    ".ply", "ply\r\nformat ascii 1.0\r\ncomment from elsewhere\r\nobj_info 1\r\nelement material 2\r\n"
            "property uchar shade\r\nproperty list uchar float spectrum\r\nelement vertex 5\r\n"
            "property float32 x\r\nproperty float y\r\nproperty float z\r\n"
            "property list uchar int uneven\r\nproperty list uchar short even\r\nproperty uchar green\r\n"
            "property uchar red\r\nproperty uchar blue\r\nelement face 4\r\nproperty uchar flags\r\n"
            "property list uint8 uint vertex_index\r\nelement edge 2\r\nproperty int vertex1\r\n"
            "property int vertex2\r\nproperty float weight\r\nelement nothing 99999999999\r\nend_header\r\n"
            "7 2 .5 1e3\r\n8 0\r\n0 0 0 0 2 7 8 1 2 3\r\n+1 0 -0 1 5 2 7 9 1 2 3\r\n1 1 0 0 2 7 8 1 2 3\r\n"
            "0 1 nan 0 2 7 8 1 2 3\r\n2 2 -inf 0 2 7 8 1 2 3\r\n"
            "0 4 0 1 2 3\r\n0 3 0 1 1\r\n0 2 3 4\r\n0 1 0\r\n0 4 0.5\r\n4 4 1\r\n");
  ASSERT_TRUE (file.good) << file.error;
  EXPECT_EQ (5u, file.cloud.width);
  EXPECT_FALSE (file.cloud.is_dense);
  EXPECT_EQ ((std::vector<SimplicialComplex::Triangle>{{0, 1, 2}, {0, 2, 3}}), file.complex.triangles);
  EXPECT_EQ ((std::vector<SimplicialComplex::Edge>{{3, 4}, {0, 4}}), file.complex.edges);
  ASSERT_EQ (5u, file.cloud.fields.size ());
  EXPECT_EQ (2u, fieldOf (file.cloud, "even").count);
  EXPECT_EQ (9, get<std::int16_t> (file.cloud, "even", 1, 1));
  EXPECT_EQ (0xff020103u, get<std::uint32_t> (file.cloud, "rgb", 2));
  EXPECT_EQ (1.f, get<float> (file.cloud, "x", 1));
}

TEST (ComplexIoFiles, PlyBigEndian)
{
  std::string bytes =
    "ply\nformat binary_big_endian 1.0\nelement vertex 2\nproperty double x\nproperty short s\n"
    "element face 1\nproperty list ushort int vertex_indices\nend_header\n";
  bytes += std::string ("\x3f\xf0\0\0\0\0\0\0\x01\x02\x40\0\0\0\0\0\0\0\xff\xfe", 20);
  bytes += std::string ("\0\2\0\0\0\1\0\0\0\0", 10);
  Loaded file (".ply", bytes);
  ASSERT_TRUE (file.good) << file.error;
  EXPECT_EQ (1.0, get<double> (file.cloud, "x", 0));
  EXPECT_EQ (2.0, get<double> (file.cloud, "x", 1));
  EXPECT_EQ (0x102, get<std::int16_t> (file.cloud, "s", 0));
  EXPECT_EQ (-2, get<std::int16_t> (file.cloud, "s", 1));
  EXPECT_EQ ((std::vector<SimplicialComplex::Edge>{{1, 0}}), file.complex.edges);
}

TEST (ComplexIoFiles, ObjOfOthers)
{
  Loaded file (".obj", "# a comment\r\nmtllib some.mtl\r\no thing\r\nv 0 0 0\r\nv 1 0 0 0.5 0.5 0.5\r\nv 1 1 "
                       "0 1.0\r\nv +0 1 1e-3\r\n"
                       "vt 0 0\r\nvn 0 0 1\r\nusemtl x\r\ns off\r\ng a b\r\nf 1 2 3\r\nf 1/1 2/1 3/1 "
                       "4/1\r\nf 1//1 2//1 \\\r\n 4//1 # end\r\n"
                       "f 1/1/1 3/1/1 -1/1/1\r\nl 1 2 3 -1\r\nl 1/1 2/1\r\np 1\r\nf 1 1 2\r\nf 5 6 7\r\n"
                       "v 0 0 1\nv 0 0 2\nv 0 0 3");
  ASSERT_TRUE (file.good) << file.error;
  EXPECT_EQ (7u, file.cloud.width);
  EXPECT_EQ ((std::vector<SimplicialComplex::Triangle>{
               {0, 1, 2}, {0, 1, 2}, {0, 2, 3}, {0, 1, 3}, {0, 2, 3}, {4, 5, 6}}),
             file.complex.triangles);
  EXPECT_EQ ((std::vector<SimplicialComplex::Edge>{{0, 1}, {1, 2}, {2, 3}, {0, 1}}), file.complex.edges);
  EXPECT_EQ (PCLPointField::FLOAT32, file.cloud.fields[0].datatype);
  EXPECT_EQ (PCLPointField::FLOAT64,
             Loaded (".obj", "v 0 0 0\nv 5123456.1234 0 0\n").cloud.fields[0].datatype);
  EXPECT_EQ (PCLPointField::FLOAT64, Loaded (".obj", "v 1e-60 0 0\n").cloud.fields[0].datatype);
  EXPECT_EQ (PCLPointField::FLOAT64, Loaded (".obj", "v 0 1e60 0\n").cloud.fields[0].datatype);
}

struct WrongFile
{
  const char* extension;
  std::string bytes;
  const char* error;
};

TEST (ComplexIoFiles, WhatIsWrongAndWhere)
{
  const std::string ply = "ply\nformat ascii 1.0\n", le = "ply\nformat binary_little_endian 1.0\n";
  const std::string vertices = "element vertex 2\nproperty float x\nproperty float y\nproperty float z\n";
  const std::string faces = "element face 1\nproperty list char int vertex_indices\n";
  const std::vector<WrongFile> files = {
    {".ply", "", "line 1: not a PLY file"},
    {".ply", "plyx\n", "line 1: not a PLY file"},
    {".ply", "ply\n", "line 1: the header has no end"},
    {".ply", "ply\nend_header\n", "line 2: the header has no format"},
    {".ply", "ply\nformat ebcdic 1.0\n", "line 2: expected a PLY format, found 'ebcdic'"},
    {".ply", ply + "element vertex many\n", "line 3: expected how many 'vertex' there are, found 'many'"},
    {".ply", ply + "element vertex -1\n", "line 3: expected how many 'vertex' there are, found '-1'"},
    {".ply", ply + "property float x\n", "line 3: expected a PLY header, found 'property'"},
    {".ply", ply + "element vertex 1\nproperty quad x\n", "line 4: expected a type, found 'quad'"},
    {".ply", ply + "element vertex 1\nproperty list float int x\n",
     "line 4: the length of a list is no whole number"},
    {".ply", ply + "element vertex 1\nproperty int x\nproperty int x\n",
     "line 5: a second property 'x' of 'vertex'"},
    {".ply", ply + "element vertex 1\nelement vertex 1\n", "line 4: a second element 'vertex'"},
    {".ply", ply + "element vertex 4000000000000\nproperty int x\nend_header\n1\n",
     "line 5: the header promises 4000000000000 of 'vertex', more than the file can hold"},
    {".ply", ply + "element vertex 4000000000000\nend_header\n",
     "line 4: more vertices than a cloud can have"},
    {".ply", ply + "element vertex 1\nend_header\n", "line 4: vertices without properties"},
    {".ply", ply + vertices + "end_header\n0 0 0\n0 zero 0\n", "line 9: expected a number, found 'zero'"},
    {".ply", ply + vertices + "end_header\n0 0 0\n0 1e\x01 0\n", "line 9: expected a number, found '1e?'"},
    {".ply", ply + vertices + "end_header\n0.0 0.0 0.0\n0 0\n",
     "line 10: expected a number, but the file ends"},
    {".ply", ply + vertices + faces + "end_header\n0 0 0\n0 0 0\n3 0 1 2\n", "line 12: there is no vertex 2"},
    {".ply", ply + vertices + faces + "end_header\n0 0 0\n0 0 0\n3 0 1 -1\n",
     "line 12: there is no vertex -1"},
    {".ply", ply + vertices + faces + "end_header\n0 0 0\n0 0 0\n3 0 nan 1\n",
     "line 12: expected a whole number, found 'nan'"},
    {".ply", ply + vertices + faces + "end_header\n0 0 0\n0 0 0\n-3 0 1 1\n",
     "line 12: a list of negative length"},
    {".ply", ply + vertices + faces + "end_header\n0 0 0\n0 0 0\n300 0 1 1\n",
     "line 12: expected a whole number, found '300'"},
    {".ply", ply + vertices + faces + "end_header\n0 0 0\n0 0 0\n9 0 1 1\n",
     "line 12: the file ends too early"},
    {".ply",
     le + vertices + faces + "end_header\n" + std::string (24, '\0') + '\3' + std::string (8, '\0') +
       "\2\0\0",
     "byte 193: the file ends too early"},
    {".ply",
     le + vertices + faces + "end_header\n" + std::string (24, '\0') + '\3' + std::string (8, '\0') +
       std::string ("\2\0\0\0", 4),
     "byte 205: there is no vertex 2"},
    {".obj", "v 0 0\n", "line 1: expected a coordinate, but the line ends"},
    {".obj", "v 0 0 0\nv 0 0 O\n", "line 2: expected a coordinate, found 'O'"},
    {".obj", "v 0 0 0\nf 1 2 1\nf 0 1 1\n", "line 3: expected the number of a point, found '0'"},
    {".obj", "v 0 0 0\nf 1 2 1\nf 1 3 1\n\n", "line 3: there is no point 3"},
    {".obj", "v 0 0 0\nf 1 -2 1\n", "line 2: there is no point -2"},
    {".obj", "v 0 0 0\nf 1 1 99999999999\n", "line 2: expected the number of a point, found '99999999999'"},
    {".obj", "v 0 0 0\nf nan 1 1\n", "line 2: expected the number of a point, found 'nan'"},
    {".obj", std::string ("v 0 0 0\n\0\1\2", 11),
     "line 2: expected a statement, found '?"
     "?"
     "?'"},
  };
  for (const WrongFile& wrong : files) {
    const Loaded file (wrong.extension, wrong.bytes);
    EXPECT_FALSE (file.good) << wrong.error;
    EXPECT_EQ (wrong.error, file.error) << wrong.bytes;
    EXPECT_TRUE (file.complex.empty ());
    EXPECT_EQ (0u, file.cloud.width);
  }
}

TEST (ComplexIoFiles, PclReadsOurPly)
{
  const TestFolder folder;
  pcl::PointCloud<pcl::PointXYZRGBNormal> cloud (10, 1), read;
  for (std::size_t i = 0; i < cloud.size (); ++i) {
    cloud[i].getVector3fMap () = Eigen::Vector3f (0.1f, 1.f / 3, 1e-7f) * static_cast<float> (i + 1);
    cloud[i].getNormalVector3fMap () = Eigen::Vector3f::UnitX ();
    cloud[i].rgba = 0xff102030u + static_cast<std::uint32_t> (i);
    cloud[i].curvature = 0.25f;
  }
  PCLPointCloud2 blob;
  pcl::toPCLPointCloud2 (cloud, blob);
  const SimplicialComplex complex = mixedComplex ();
  for (const bool ascii : {false, true}) {
    std::string error;
    ASSERT_TRUE (saveComplex (folder / "a.ply", blob, complex, error, ascii)) << error;
    ASSERT_EQ (0, pcl::io::loadPLYFile (folder / "a.ply", read));
    ASSERT_EQ (cloud.size (), read.size ());
    for (std::size_t i = 0; i < cloud.size (); ++i) {
      EXPECT_EQ (cloud[i].getVector3fMap (), read[i].getVector3fMap ());
      EXPECT_EQ (cloud[i].getNormalVector3fMap (), read[i].getNormalVector3fMap ());
      EXPECT_EQ (cloud[i].rgba & 0xffffffu, read[i].rgba & 0xffffffu);
      EXPECT_EQ (cloud[i].curvature, read[i].curvature);
    }
    pcl::PolygonMesh mesh;
    ASSERT_EQ (0, pcl::io::loadPLYFile (folder / "a.ply", mesh));
    EXPECT_EQ (2u + 6u, mesh.polygons.size ());
    EXPECT_EQ ((pcl::Indices{2, 3, 4}), mesh.polygons[0].vertices);
  }
}

TEST (ComplexIoFiles, PclReadsOurObj)
{
  const TestFolder folder;
  const PCLPointCloud2 cloud = pointsXYZ (10);
  SimplicialComplex complex = mixedComplex ();
  complex.edges.clear ();
  std::string error;
  ASSERT_TRUE (saveComplex (folder / "a.obj", cloud, complex, error)) << error;
  pcl::PolygonMesh mesh;
  ASSERT_EQ (0, pcl::io::loadOBJFile (folder / "a.obj", mesh));
  EXPECT_EQ (8u, mesh.polygons.size ());
  EXPECT_EQ (10u, mesh.cloud.width);
}

TEST (ComplexIoFiles, OursReadsPclsPly)
{
  const TestFolder folder;
  pcl::PointCloud<pcl::PointXYZRGBA> cloud (4, 3);
  for (std::size_t i = 0; i < cloud.size (); ++i) {
    cloud[i].getVector3fMap () = Eigen::Vector3f (0.1f, 1.f / 3, 1e-7f) * static_cast<float> (i + 1);
    cloud[i].rgba = 0x80102030u + static_cast<std::uint32_t> (i);
  }
  pcl::PolygonMesh mesh;
  pcl::toPCLPointCloud2 (cloud, mesh.cloud);
  mesh.polygons.resize (2);
  mesh.polygons[0].vertices = {0, 1, 2};
  mesh.polygons[1].vertices = {3, 4};
  ASSERT_EQ (0, pcl::io::savePLYFileBinary (folder / "cloud.ply", cloud));
  ASSERT_EQ (0, pcl::io::savePLYFileBinary (folder / "mesh.ply", mesh));
  for (const char* const name : {"cloud.ply", "mesh.ply"}) {
    PCLPointCloud2 read;
    SimplicialComplex complex;
    std::string error;
    ASSERT_TRUE (loadComplex (folder / name, read, complex, error)) << error;
    EXPECT_EQ (bytesOf (mesh.cloud, "x"), bytesOf (read, "x"));
    if (name[0] == 'm') {
      EXPECT_EQ ((std::vector<SimplicialComplex::Triangle>{{0, 1, 2}}), complex.triangles);
      EXPECT_EQ ((std::vector<SimplicialComplex::Edge>{{3, 4}}), complex.edges);
    } else
      EXPECT_EQ (bytesOf (mesh.cloud, "rgba"), bytesOf (read, "rgba"));
  }
}

} // namespace
