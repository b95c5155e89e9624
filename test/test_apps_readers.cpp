// Clouds of all formats but PCD: every field, every kind of bad file.
#include "test_apps_clouds.h"

#include <pcl/io/ply_io.h>
#include <pcl/manifold/complex_io.h>
#include <pcl/point_types.h>

#include <cmath>
#include <cstring>
#include <random>
#include <vector>

using namespace pcl::manifold;
using namespace pcl::manifold::apps;

TEST (Ply, KeepsEveryProperty)
{
  const TestFolder folder;
  const std::string header =
    "element camera 1\nproperty list uchar int views\nproperty double f\n"
    "element vertex 2\nproperty float x\nproperty float y\nproperty float z\n"
    "property float nx\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
    "property short s\nelement face 0\nproperty list uchar int vertex_indices\n"
    "end_header\n";
  const std::string text = "ply\nformat ascii 1.0\ncomment c\nobj_info o\n" + header +
                           "2 8 9 0.5\n1 2 3 0.5 255 128 1 -2\n4 5 6 7 0 0 0 9\n";
  std::string little = "ply\nformat binary_little_endian 1.0\n" + header;
  std::string big = "ply\nformat binary_big_endian 1.0\n" + header;
  const auto append = [&] (auto value) {
    char bytes[sizeof (value)];
    std::memcpy (bytes, &value, sizeof (value));
    little.append (bytes, sizeof (value));
    for (std::size_t i = sizeof (value); i > 0; --i)
      big += bytes[i - 1];
  };
  append (std::uint8_t (2));
  append (std::int32_t (8));
  append (std::int32_t (9));
  append (0.5);
  for (int point = 0; point < 2; ++point) {
    for (const float value : {1.0f, 2.0f, 3.0f})
      append (value + 3 * static_cast<float> (point));
    append (point == 0 ? 0.5f : 7.0f);
    for (const std::uint8_t value : {255, 128, 1})
      append (static_cast<std::uint8_t> (point == 0 ? value : 0));
    append (static_cast<std::int16_t> (point == 0 ? -2 : 9));
  }
  const pcl::PCLPointCloud2 expected = readCloud (folder.write ("text.ply", text)).cloud;
  EXPECT_EQ (expected.width, 2u);
  EXPECT_EQ (valueAt (expected, "z", 1), 6);
  EXPECT_EQ (valueAt (expected, "normal_x", 0), 0.5);
  EXPECT_EQ (valueAt (expected, "s", 0), -2);
  EXPECT_EQ (expected.fields.size (), 6u);
  pcl::PointCloud<pcl::PointXYZRGB> colours;
  pcl::fromPCLPointCloud2 (expected, colours);
  EXPECT_EQ (colours[0].r, 255);
  EXPECT_EQ (colours[0].g, 128);
  EXPECT_EQ (colours[0].b, 1);
  expectSameFields (expected, readCloud (folder.write ("little.ply", little)).cloud);
  expectSameFields (expected, readCloud (folder.write ("big.ply", big)).cloud);

  for (const std::string& good : {text, little, big}) {
    for (std::size_t size = 0; size < good.size () - 2; ++size)
      EXPECT_NE (readingError (folder.write ("bad.ply", good.substr (0, size))), "") << size;
    std::mt19937 random (13);
    for (int i = 0; i < 600; ++i) {
      std::string bad = good;
      for (int flips = i % 4; flips >= 0; --flips)
        bad[random () % bad.size ()] ^= static_cast<char> (1 << random () % 8);
      readingError (folder.write ("bad.ply", bad));
    }
  }
}

TEST (Ply, IsReadAsByPcl)
{
  const TestFolder folder;
  pcl::PointCloud<pcl::PointXYZRGBNormal> points (30, 1);
  for (std::size_t i = 0; i < points.size (); ++i) {
    points[i].x = static_cast<float> (i) / 3;
    points[i].normal_z = static_cast<float> (i) / 7;
    points[i].r = static_cast<std::uint8_t> (i);
  }
  pcl::PLYWriter ().write (folder / "a.ply", points, true, false);
  pcl::PointCloud<pcl::PointXYZRGBNormal> again;
  pcl::fromPCLPointCloud2 (readCloud (folder / "a.ply").cloud, again);
  ASSERT_EQ (again.size (), points.size ());
  for (std::size_t i = 0; i < points.size (); ++i) {
    EXPECT_EQ (again[i].x, points[i].x);
    EXPECT_EQ (again[i].normal_z, points[i].normal_z);
    EXPECT_EQ (again[i].r, points[i].r);
  }
}

TEST (Off, GivesItsVertices)
{
  const TestFolder folder;
  const InputCloud input =
    readCloud (folder.write ("a.OFF", "OFF # c\n# c\n\n 3 1 0\n1 2 3\n\n4 5 6 255 0 0\n7 8 9\n3 0 1 2\n"));
  EXPECT_EQ (input.size (), 3u);
  EXPECT_EQ (valueAt (input.cloud, "y", 1), 5);
  EXPECT_EQ (readCloud (folder.write ("b.off", "COFF 1 0 0\n1 2 3 4 5 6 7")).size (), 1u);
  EXPECT_TRUE (contains (readingError (folder.write ("c.off", "OFF\n99999999999 1 0\n1 2 3\n")),
                         "truncated: the file ends with 1 of 99999999999 vertices"));
  EXPECT_TRUE (contains (readingError (folder.write ("c.off", "OFF\n2 1 0\n1 2 3\n1 2\n")),
                         "line 4: a vertex needs three numbers"));
  EXPECT_TRUE (
    contains (readingError (folder.write ("c.off", "OFF\n")), "the number of vertices is missing"));
  EXPECT_TRUE (contains (readingError (folder.write ("c.off", "PNG\n")), "not an OFF file"));
}

TEST (Obj, GivesItsVertices)
{
  const TestFolder folder;
  const InputCloud input = readCloud (
    folder.write ("a.obj", "# c\no name\nv 1 2 3\nvn 0 0 1\nv 4 5 6 0.5 0.5 0.5\nf 1 2 2\nl 1 2\n"));
  EXPECT_EQ (input.size (), 2u);
  EXPECT_EQ (valueAt (input.cloud, "z", 1), 6);
  EXPECT_TRUE (contains (readingError (folder.write ("b.obj", "v 1 2\n")), "b.obj: line 1: "));
  EXPECT_TRUE (contains (readingError (folder.write ("b.obj", "v 1 2 x\n")), "b.obj: line 1: "));
  EXPECT_TRUE (contains (readingError (folder.write ("b.obj", "# none\n")), "b.obj: holds no point"));
}

TEST (Obj, GivesColoursAndNormals)
{
  const TestFolder folder;
  const std::string points =
    "vn 0 0 1\nv 1 2 3 1 0.5 0\nvn 0 1 0\nv 4 5 6 0 1 0.2\nvn 1 0 0\nv 7 8 9 0 0 1\n";
  const InputCloud input = readCloud (folder.write ("a.obj", points + "f 1//1 2//2 3//3\n"));
  EXPECT_TRUE (input.notes.empty ());
  pcl::PointCloud<pcl::PointXYZRGBNormal> cloud;
  pcl::fromPCLPointCloud2 (input.cloud, cloud);
  ASSERT_EQ (cloud.size (), 3u);
  EXPECT_EQ (cloud[0].getRGBVector3i (), Eigen::Vector3i (255, 128, 0));
  EXPECT_EQ (cloud[1].getRGBVector3i (), Eigen::Vector3i (0, 255, 51));
  EXPECT_EQ (cloud[1].getNormalVector3fMap (), Eigen::Vector3f::UnitY ());
  EXPECT_EQ (cloud[2].getNormalVector3fMap (), Eigen::Vector3f::UnitX ());

  // The faces say which normal belongs to which point; without faces it is their order.
  const InputCloud turned = readCloud (folder.write ("a.obj", points + "f -3/1/3 2/1/-2 3//1\n"));
  EXPECT_EQ (valueAt (turned.cloud, "normal_x", 0), 1);
  EXPECT_EQ (valueAt (turned.cloud, "normal_z", 2), 1);
  EXPECT_EQ (valueAt (readCloud (folder.write ("a.obj", points)).cloud, "normal_z", 0), 1);
  // Bytes instead of fractions.
  const InputCloud bytes = readCloud (folder.write ("a.obj", "v 1 2 3 255 128 1e9\nv 4 5 6 nan 0 -1\n"));
  pcl::fromPCLPointCloud2 (bytes.cloud, cloud);
  EXPECT_EQ (cloud[0].getRGBVector3i (), Eigen::Vector3i (255, 128, 255));
  EXPECT_EQ (cloud[1].getRGBVector3i (), Eigen::Vector3i (0, 0, 0));
}

TEST (Obj, SaysWhatItLeavesOut)
{
  const TestFolder folder;
  const auto notes = [&] (const std::string& text) {
    const InputCloud input = readCloud (folder.write ("a.obj", text));
    EXPECT_EQ (input.cloud.fields.size (), 3u);
    std::string all;
    for (const std::string& note : input.notes)
      all += note + ";";
    return all;
  };
  EXPECT_EQ (notes ("v 1 2 3\nv 4 5 6 0.5 0.5 0.5\n"), "colours left out: not every point has one;");
  const std::string normals = "normals left out: not every point has one of its own;";
  EXPECT_EQ (notes ("v 1 2 3\nv 4 5 6\nvn 0 0 1\n"), normals);
  EXPECT_EQ (notes ("v 1 2 3\nv 4 5 6\nvn 0 0 1\nvn 0 1 0\nf 1//1 2//2 1//2\n"), normals)
    << "two of one point";
  EXPECT_EQ (notes ("v 1 2 3\nv 4 5 6\nvn 0 0 1\nvn 0 1 0\nf 1//1 2//7 2//7\n"), normals)
    << "there is no seventh";
  EXPECT_EQ (notes ("v 1 2 3 1.0\nv 4 5 6 1.0\n"), "") << "weights";
}

TEST (Ply, SaysThatListsOfSeveralLengthsAreLeftOut)
{
  const TestFolder folder;
  const std::string text = "ply \nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
                           "property float z\nproperty list uchar int views\nproperty list uchar int pair\n"
                           "end_header\n1 2 3 1 9 2 1 2\n4 5 6 0 2 3 4\n";
  const InputCloud input = readCloud (folder.write ("a.ply", text));
  EXPECT_EQ (input.cloud.fields.size (), 4u);
  EXPECT_EQ (findField (input.cloud, "pair")->count, 2u);
  ASSERT_EQ (input.notes.size (), 1u);
  EXPECT_EQ (input.notes[0], "left out, lists of the vertices that are empty or of several lengths: 'views'");
}

TEST (Ply, KeepsTheLayoutOfAnOrganisedCloud)
{
  const TestFolder folder;
  pcl::PointCloud<pcl::PointXYZ> points (4, 3);
  pcl::PCLPointCloud2 cloud;
  pcl::toPCLPointCloud2 (points, cloud);
  std::string error;
  ASSERT_TRUE (saveComplex (folder / "a.ply", cloud, pcl::SimplicialComplex (), error)) << error;
  pcl::PCLPointCloud2 by_pcl;
  ASSERT_EQ (pcl::io::loadPLYFile (folder / "a.ply", by_pcl), 0);
  for (const pcl::PCLPointCloud2& read : {readCloud (folder / "a.ply").cloud, by_pcl}) {
    EXPECT_EQ (read.width, 4u);
    EXPECT_EQ (read.height, 3u);
    EXPECT_EQ (read.row_step, 4 * read.point_step);
  }
  // What contradicts the number of vertices is not believed.
  std::string text = folder.read ("a.ply");
  text.replace (text.find ("num_rows 3"), 10, "num_rows 5");
  EXPECT_EQ (readCloud (folder.write ("b.ply", text)).cloud.height, 1u);
}

TEST (Ply, KeepsTheSensorThatPclWrites)
{
  const TestFolder folder;
  pcl::PointCloud<pcl::PointXYZ> points (4, 3);
  pcl::PCLPointCloud2 cloud;
  pcl::toPCLPointCloud2 (points, cloud);
  const Eigen::Quaternionf turn (Eigen::AngleAxisf (0.7f, Eigen::Vector3f (1, 2, 3).normalized ()));
  for (const bool binary : {false, true}) {
    ASSERT_EQ (
      pcl::PLYWriter ().write (folder / "a.ply", cloud, Eigen::Vector4f (1, -2, 30, 0), turn, binary, true),
      0);
    const InputCloud input = readCloud (folder / "a.ply");
    EXPECT_EQ (input.cloud.width, 4u);
    EXPECT_EQ (input.cloud.height, 3u);
    const Viewpoint& view = input.viewpoint;
    EXPECT_EQ (view[0], 1);
    EXPECT_EQ (view[1], -2);
    EXPECT_EQ (view[2], 30);
    const Eigen::Quaterniond read (view[3], view[4], view[5], view[6]);
    EXPECT_LT (read.angularDistance (turn.cast<double> ()), 1e-4);
  }
  // Such a camera has no axes.
  const std::string other =
    "ply\nformat ascii 1.0\nelement camera 1\nproperty float view_px\nelement vertex 1\n"
    "property float x\nproperty float y\nproperty float z\nend_header\n7\n1 2 3\n";
  EXPECT_EQ (readCloud (folder.write ("b.ply", other)).viewpoint, (Viewpoint{0, 0, 0, 1, 0, 0, 0}));
}

TEST (Reader, DoesNotReadWhatIsOnlyWritten)
{
  const TestFolder folder;
  EXPECT_TRUE (contains (readingError (folder.write ("a.vtk", "# vtk DataFile Version 3.0\n")),
                         "unknown type of file; known are .pcd .ply .xyz .txt .off .obj"));
}

TEST (Reader, RefusesWhatIsNoFile)
{
  const TestFolder folder;
  EXPECT_TRUE (contains (readingError (folder / "missing.pcd"), "No such file"));
  EXPECT_TRUE (contains (readingError ("/dev/null.pcd"), "No such file"));
  EXPECT_TRUE (
    contains (readingError (folder.write ("a.las", "LASF")), "unknown type of file; known are .pcd"));
  std::filesystem::create_directory (folder / "folder.pcd");
  EXPECT_TRUE (contains (readingError (folder / "folder.pcd"), "cannot be read: it is a folder"));
  std::filesystem::create_symlink ("/dev/zero", folder / "zero.xyz");
  EXPECT_TRUE (contains (readingError (folder / "zero.xyz"), "cannot be read: it is no regular file"));
}

// Rows of zeros among map coordinates, which a sensor's driver or a conversion leaves, and a stray.
TEST (Coordinates, AreShiftedByTheirBulk)
{
  const TestFolder folder;
  std::string rows;
  for (int i = 0; i < 400; ++i)
    rows += std::to_string (621300 + i % 20) + ".125 " + std::to_string (5811200 + i / 20) + ".25 " +
            std::to_string (-i % 7) + "\n";
  const InputCloud clean = readCloud (folder.write ("clean.xyz", rows));
  EXPECT_EQ (clean.origin, (std::array<double, 3>{621300, 5811200, 0}));
  ASSERT_EQ (clean.notes.size (), 1u);
  EXPECT_EQ (clean.notes[0], "coordinates shifted: origin 621300 5811200 0 subtracted"); // not -0
  for (const std::string extra : {"0 0 0\n0 0 0\n0 0 0\n", "0 0 0\n", "621300 5811200 -9999999\n"}) {
    const InputCloud cloud = readCloud (folder.write ("more.xyz", extra + rows));
    const std::size_t added = cloud.size () - clean.size ();
    EXPECT_NEAR (cloud.origin[0], 621300, 1000) << extra;
    EXPECT_NEAR (cloud.origin[1], 5811200, 1000) << extra;
    EXPECT_EQ (cloud.no_measurement, added == 3 ? 3u : 0u) << extra;
    for (std::size_t i = 0; i < clean.size (); ++i)
      for (int axis = 0; axis < 3; ++axis) {
        const std::string name (1, "xyz"[axis]);
        ASSERT_EQ (valueAt (cloud.cloud, name, i + added) + cloud.origin[axis],
                   valueAt (clean.cloud, name, i) + clean.origin[axis])
          << extra;
      }
    for (std::size_t i = 0; i < added; ++i)
      EXPECT_EQ (std::isnan (valueAt (cloud.cloud, "x", i)), added == 3) << extra;
  }
}

TEST (Coordinates, AreShiftedWhereFloatsAreTooCoarse)
{
  const TestFolder folder;
  const InputCloud map =
    readCloud (folder.write ("map.xyz", "621300.125 5811200.25 30.5\n621340.5 5811240.75 31.25\nnan 0 0\n"));
  EXPECT_EQ (map.origin, (std::array<double, 3>{621300, 5811200, 0}));
  EXPECT_EQ (valueAt (map.cloud, "x", 0), 0.125);
  EXPECT_EQ (valueAt (map.cloud, "y", 1), 40.75);
  EXPECT_EQ (valueAt (map.cloud, "z", 1), 31.25);
  EXPECT_TRUE (std::isnan (valueAt (map.cloud, "x", 2)));
  ASSERT_EQ (map.notes.size (), 1u);
  EXPECT_EQ (map.notes[0], "coordinates shifted: origin 621300 5811200 0 subtracted");

  const InputCloud near = readCloud (folder.write ("near.xyz", "1 2 3\n4 5 6\n"));
  EXPECT_EQ (near.origin, (std::array<double, 3>{}));
  EXPECT_TRUE (near.notes.empty ());
  EXPECT_EQ (near.cloud.fields[0].name, "x");
  EXPECT_TRUE (contains (readingError (folder.write ("far.xyz", "1 2 3\n1e300 5 6\n")),
                         "coordinate 'x' of point 1 is larger than PCL's floats can hold"));
}
