#include "test_apps_folder.h"

#include <pcl/manifold/complex_io.h>

#include <pcl/conversions.h>
#include <pcl/io/obj_io.h>
#include <pcl/io/ply_io.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>
#include <random>

#include <csignal>
#include <sys/resource.h>

namespace {

namespace fs = std::filesystem;
using pcl::PCLPointCloud2;
using pcl::PCLPointField;
using pcl::SimplicialComplex;
using pcl::manifold::canSaveComplex;
using pcl::manifold::isValid;
using pcl::manifold::loadComplex;
using pcl::manifold::saveComplex;

struct Field
{
  std::string name;
  std::uint8_t type;
  pcl::uindex_t count;
};

/** \brief A cloud whose bytes are all zero. */
PCLPointCloud2
blankCloud (const std::vector<Field>& fields, std::size_t points)
{
  PCLPointCloud2 cloud;
  for (const Field& field : fields) {
    PCLPointField own;
    own.name = field.name;
    own.datatype = field.type;
    own.count = field.count;
    own.offset = cloud.point_step;
    cloud.point_step += field.count * static_cast<pcl::uindex_t> (pcl::getFieldSize (field.type));
    cloud.fields.push_back (own);
  }
  cloud.height = 1;
  cloud.width = static_cast<pcl::uindex_t> (points);
  cloud.row_step = cloud.width * cloud.point_step;
  cloud.data.resize (cloud.row_step);
  cloud.is_dense = true;
  return cloud;
}

const PCLPointField&
fieldOf (const PCLPointCloud2& cloud, const std::string& name)
{
  for (const PCLPointField& field : cloud.fields)
    if (field.name == name)
      return field;
  throw std::out_of_range ("no field " + name);
}

template <typename T>
T&
at (PCLPointCloud2& cloud, const std::string& name, std::size_t point, std::size_t value = 0)
{
  return *reinterpret_cast<T*> (cloud.data.data () + point * cloud.point_step + fieldOf (cloud, name).offset +
                                value * sizeof (T));
}

/** \brief All bytes of all points of one field. */
std::vector<std::uint8_t>
bytesOf (const PCLPointCloud2& cloud, const std::string& name)
{
  const PCLPointField& field = fieldOf (cloud, name);
  const std::size_t size =
    std::max (1u, field.count) * static_cast<std::size_t> (pcl::getFieldSize (field.datatype));
  std::vector<std::uint8_t> bytes;
  for (std::size_t i = 0; i < cloud.width * cloud.height; ++i) {
    const auto first =
      cloud.data.begin () + static_cast<std::ptrdiff_t> (i * cloud.point_step + field.offset);
    bytes.insert (bytes.end (), first, first + static_cast<std::ptrdiff_t> (size));
  }
  return bytes;
}

/** \brief The x, y, z of a few points, in float. */
PCLPointCloud2
pointsXYZ (std::size_t points)
{
  PCLPointCloud2 cloud = blankCloud (
    {{"x", PCLPointField::FLOAT32, 1}, {"y", PCLPointField::FLOAT32, 1}, {"z", PCLPointField::FLOAT32, 1}},
    points);
  std::mt19937_64 random (points);
  for (std::size_t i = 0; i < points; ++i)
    for (const char* const name : {"x", "y", "z"})
      at<float> (cloud, name, i) = static_cast<float> (random ()) * 1e-19f;
  return cloud;
}

/** \brief Many kinds of fields with random contents. */
PCLPointCloud2
richCloud (std::size_t points, std::uint8_t coordinate)
{
  PCLPointCloud2 cloud = blankCloud ({{"intensity", PCLPointField::FLOAT32, 1},
                                      {"x", coordinate, 1},
                                      {"y", coordinate, 1},
                                      {"z", coordinate, 1},
                                      {"rgb", PCLPointField::FLOAT32, 1},
                                      {"label", PCLPointField::UINT32, 1},
                                      {"fpfh", PCLPointField::FLOAT32, 33},
                                      {"time", PCLPointField::FLOAT64, 1},
                                      {"ring", PCLPointField::UINT16, 1},
                                      {"angle", PCLPointField::INT16, 2},
                                      {"class", PCLPointField::UINT8, 1},
                                      {"offset", PCLPointField::INT8, 1},
                                      {"id", PCLPointField::INT32, 1}},
                                     points);
  std::mt19937_64 random (7);
  for (std::uint8_t& byte : cloud.data)
    byte = static_cast<std::uint8_t> (random ());
  for (std::size_t i = 0; i < points; ++i) {
    // Random bits may be a NaN, of which text keeps no more than that it is one.
    at<float> (cloud, "intensity", i) = static_cast<float> (i) / 3;
    for (std::size_t k = 0; k < 33; ++k)
      at<float> (cloud, "fpfh", i, k) = static_cast<float> (random ()) * 1e-20f;
    at<double> (cloud, "time", i) = 1.7e9 + static_cast<double> (i) / 7;
    for (const char* const name : {"x", "y", "z"})
      if (coordinate == PCLPointField::FLOAT64)
        at<double> (cloud, name, i) = 5e6 + static_cast<double> (random ()) * 1e-19;
      else
        at<float> (cloud, name, i) = static_cast<float> (random ()) * 1e-19f;
    at<std::uint32_t> (cloud, "rgb", i) |= 0xff000000u;
  }
  return cloud;
}

/** \brief Edges, triangles and tetrahedra over ten points. */
SimplicialComplex
mixedComplex ()
{
  SimplicialComplex complex;
  complex.edges = {{0, 1}, {1, 2}};
  complex.triangles = {{2, 3, 4}, {4, 3, 5}};
  complex.tetrahedra = {{5, 6, 7, 8}, {6, 7, 8, 9}};
  return complex;
}

struct FormatCase
{
  const char* extension;
  bool ascii;
};

class EveryFormat : public testing::TestWithParam<FormatCase>
{
protected:
  bool isVtk () const { return GetParam ().extension[1] == 'v'; }

  bool isObj () const { return GetParam ().extension == std::string (".obj"); }

  void save (const PCLPointCloud2& cloud, const SimplicialComplex& complex)
  {
    std::string error;
    EXPECT_TRUE (saveComplex (file_, cloud, complex, error, GetParam ().ascii)) << error;
    EXPECT_EQ ("", error);
  }

  void roundTrip (const PCLPointCloud2& cloud, const SimplicialComplex& complex)
  {
    save (cloud, complex);
    std::string error;
    ASSERT_TRUE (loadComplex (file_, cloud_, complex_, error)) << error;
    EXPECT_EQ (cloud.width * cloud.height, cloud_.width);
    EXPECT_EQ (complex.edges, complex_.edges);
    if (isVtk ()) {
      EXPECT_EQ (complex.triangles, complex_.triangles);
      EXPECT_EQ (complex.tetrahedra, complex_.tetrahedra);
      return;
    }
    std::vector<SimplicialComplex::Triangle> triangles = complex.triangles;
    for (const auto& t : pcl::manifold::boundaryTriangles (complex.tetrahedra))
      triangles.push_back (t);
    EXPECT_EQ (triangles, complex_.triangles);
    EXPECT_TRUE (complex_.tetrahedra.empty ());
  }

  TestFolder folder_;
  const std::string name_ = std::string ("file") + GetParam ().extension;
  const std::string file_ = folder_ / name_;
  PCLPointCloud2 cloud_;
  SimplicialComplex complex_;
};

TEST_P (EveryFormat, NothingAtAll)
{
  roundTrip (PCLPointCloud2 (), SimplicialComplex ());
  roundTrip (pointsXYZ (0), SimplicialComplex ());
  EXPECT_EQ (0u, cloud_.width);
}

TEST_P (EveryFormat, OnePoint)
{
  const PCLPointCloud2 cloud = pointsXYZ (1);
  roundTrip (cloud, SimplicialComplex ());
  EXPECT_EQ (cloud.data, cloud_.data);
  EXPECT_TRUE (cloud_.is_dense);
}

TEST_P (EveryFormat, StrangeCoordinates)
{
  PCLPointCloud2 cloud = pointsXYZ (3);
  using Limits = std::numeric_limits<float>;
  const float values[] = {Limits::quiet_NaN (),
                          Limits::infinity (),
                          -Limits::infinity (),
                          Limits::max (),
                          Limits::min (),
                          Limits::denorm_min (),
                          -0.f,
                          0.1f,
                          -Limits::epsilon ()};
  std::memcpy (cloud.data.data (), values, sizeof (values));
  roundTrip (cloud, SimplicialComplex ());
  EXPECT_EQ (cloud.data, cloud_.data);
  EXPECT_FALSE (cloud_.is_dense);
}

TEST_P (EveryFormat, MixedComplex)
{
  const PCLPointCloud2 cloud = pointsXYZ (10);
  roundTrip (cloud, mixedComplex ());
  EXPECT_EQ (cloud.data, cloud_.data);
}

TEST_P (EveryFormat, DoubleCoordinates)
{
  const PCLPointCloud2 cloud = richCloud (10, PCLPointField::FLOAT64);
  roundTrip (cloud, mixedComplex ());
  for (const char* const name : {"x", "y", "z"}) {
    EXPECT_EQ (PCLPointField::FLOAT64, fieldOf (cloud_, name).datatype);
    EXPECT_EQ (bytesOf (cloud, name), bytesOf (cloud_, name));
  }
}

TEST_P (EveryFormat, AllFields)
{
  const PCLPointCloud2 cloud = richCloud (10, PCLPointField::FLOAT32);
  roundTrip (cloud, mixedComplex ());
  if (isObj ())
    return; // coordinates only
  ASSERT_EQ (cloud.fields.size (), cloud_.fields.size ());
  for (const PCLPointField& field : cloud.fields) {
    EXPECT_EQ (field.datatype, fieldOf (cloud_, field.name).datatype) << field.name;
    EXPECT_EQ (field.count, fieldOf (cloud_, field.name).count) << field.name;
    EXPECT_EQ (bytesOf (cloud, field.name), bytesOf (cloud_, field.name)) << field.name;
  }
}

TEST_P (EveryFormat, SavedAgainIsTheSame)
{
  roundTrip (richCloud (10, PCLPointField::FLOAT32), mixedComplex ());
  const std::string before = folder_.read (name_);
  const PCLPointCloud2 cloud = cloud_;
  const SimplicialComplex complex = complex_;
  roundTrip (cloud, complex);
  EXPECT_EQ (before, folder_.read (name_));
  EXPECT_EQ (1, folder_.count ());
}

TEST_P (EveryFormat, ColourWithAlphaOrganizedAndPadded)
{
  PCLPointCloud2 cloud = blankCloud ({{"x", PCLPointField::FLOAT32, 1},
                                      {"y", PCLPointField::FLOAT32, 1},
                                      {"z", PCLPointField::FLOAT32, 0},
                                      {"_", PCLPointField::UINT8, 4},
                                      {"rgba", PCLPointField::UINT32, 1},
                                      {"seen", PCLPointField::BOOL, 1}},
                                     6);
  cloud.fields[2].count = 0; // as some of PCL's readers leave it
  cloud.fields[4].offset = 16;
  cloud.fields[3].offset = 12;
  cloud.fields[5].offset = 20;
  cloud.point_step = 24;
  cloud.width = 3;
  cloud.height = 2;
  cloud.data.assign (6 * 24, 0);
  at<std::uint32_t> (cloud, "rgba", 5) = 0x12345678;
  at<std::uint8_t> (cloud, "seen", 4) = 1;
  roundTrip (cloud, SimplicialComplex ());
  if (isObj ())
    return;
  EXPECT_EQ (5u, cloud_.fields.size ());
  EXPECT_EQ (0x12345678u, at<std::uint32_t> (cloud_, "rgba", 5));
  EXPECT_EQ (1, at<std::uint8_t> (cloud_, "seen", 4));
}

TEST_P (EveryFormat, FailuresLeaveTheTargetAlone)
{
  const PCLPointCloud2 cloud = pointsXYZ (10);
  save (cloud, SimplicialComplex ());
  const std::string before = folder_.read (name_);
  std::string error;

  SimplicialComplex wrong;
  wrong.triangles = {{0, 1, 10}};
  EXPECT_FALSE (saveComplex (file_, cloud, wrong, error, GetParam ().ascii));
  EXPECT_EQ ("triangle 0 has a vertex that the cloud has not: 0, 1, 10", error);

  PCLPointCloud2 broken = cloud;
  broken.data.resize (50);
  EXPECT_FALSE (saveComplex (file_, broken, SimplicialComplex (), error, GetParam ().ascii));
  broken = cloud;
  broken.fields[1].offset = 1000;
  EXPECT_FALSE (saveComplex (file_, broken, SimplicialComplex (), error, GetParam ().ascii));
  broken = cloud;
  broken.fields[1].datatype = 77;
  EXPECT_FALSE (saveComplex (file_, broken, SimplicialComplex (), error, GetParam ().ascii));
  broken = cloud;
  broken.fields.clear ();
  EXPECT_FALSE (saveComplex (file_, broken, SimplicialComplex (), error, GetParam ().ascii));
  EXPECT_EQ (before, folder_.read (name_));
  EXPECT_EQ (1, folder_.count ());
}

TEST_P (EveryFormat, FullDisk)
{
  const PCLPointCloud2 cloud = pointsXYZ (10);
  save (cloud, SimplicialComplex ());
  const std::string before = folder_.read (name_);
  // A limit on the size of files fails as a full disk does: in the middle, or when buffers are flushed.
  std::signal (SIGXFSZ, SIG_IGN);
  rlimit unlimited;
  getrlimit (RLIMIT_FSIZE, &unlimited);
  for (const rlim_t size : {0u, 100u, 100000u, 1100000u}) {
    const rlimit limit{size, unlimited.rlim_max};
    setrlimit (RLIMIT_FSIZE, &limit);
    std::string error;
    const bool saved =
      saveComplex (file_, pointsXYZ (100000), SimplicialComplex (), error, GetParam ().ascii);
    setrlimit (RLIMIT_FSIZE, &unlimited);
    EXPECT_FALSE (saved) << size;
    EXPECT_EQ ("cannot be written: File too large", error);
  }
  EXPECT_EQ (before, folder_.read (name_));
  EXPECT_EQ (1, folder_.count ());
}

/** \brief A file may be refused or not, but nothing else may happen. */
void
expectSane (const std::string& file)
{
  PCLPointCloud2 cloud;
  SimplicialComplex complex;
  std::string error;
  if (loadComplex (file, cloud, complex, error)) {
    EXPECT_TRUE (isValid (complex, cloud.width));
    EXPECT_EQ (cloud.data.size (), static_cast<std::size_t> (cloud.width) * cloud.point_step);
    EXPECT_EQ ("", error);
  } else {
    EXPECT_TRUE (complex.empty ());
    EXPECT_TRUE (cloud.data.empty ());
    EXPECT_NE ("", error);
    EXPECT_EQ (std::string::npos, error.find ('\n'));
  }
}

TEST_P (EveryFormat, TruncatedAndCorruptFiles)
{
  save (richCloud (10, PCLPointField::FLOAT32), mixedComplex ());
  const std::string good = folder_.read (name_);
  for (std::size_t size = 0; size < good.size (); size += 7) {
    fs::remove (file_); // some file systems wait for the disk where a file is overwritten
    folder_.write (name_, good.substr (0, size));
    expectSane (file_);
  }
  std::mt19937_64 random (11);
  for (int round = 0; round < 2000; ++round) {
    std::string bad = good;
    for (std::uint64_t i = 0, n = 1 + random () % 4; i < n; ++i) {
      const std::size_t place =
        random () % (round % 2 == 0 ? bad.size () : std::min<std::size_t> (900, bad.size ()));
      switch (random () % 3) {
        case 0:
          bad[place] = static_cast<char> (random ());
          break;
        case 1:
          bad.insert (place, 1, static_cast<char> ('0' + random () % 10));
          break;
        default:
          bad.erase (place, 1 + random () % 3);
      }
    }
    fs::remove (file_);
    folder_.write (name_, bad);
    expectSane (file_);
  }
}

TEST_P (EveryFormat, OtherFilesThanTheExtensionSays)
{
  for (const char* const extension : {".ply", ".obj", ".vtk", ".vtu"}) {
    std::string error;
    const std::string other = std::string ("other") + extension;
    ASSERT_TRUE (saveComplex (folder_ / other, pointsXYZ (10), mixedComplex (), error));
    folder_.write (name_, folder_.read (other));
    expectSane (file_);
  }
}

INSTANTIATE_TEST_SUITE_P (ComplexIo, EveryFormat,
                          testing::Values (FormatCase{".ply", false}, FormatCase{".ply", true},
                                           FormatCase{".obj", true}, FormatCase{".vtk", false},
                                           FormatCase{".vtk", true}, FormatCase{".vtu", false},
                                           FormatCase{".vtu", true}),
                          [] (const auto& test) {
                            return std::string (test.param.extension + 1) +
                                   (test.param.ascii ? "_ascii" : "_binary");
                          });

TEST (ComplexIo, NamesThatCannotBeWritten)
{
  const TestFolder folder;
  std::string error;
  EXPECT_FALSE (canSaveComplex (folder / "file.stl", error));
  EXPECT_EQ ("unknown extension .stl; use .ply, .obj, .vtk or .vtu", error);
  EXPECT_FALSE (canSaveComplex (folder / "file", error));
  EXPECT_EQ ("no extension; use .ply, .obj, .vtk or .vtu", error);
  EXPECT_FALSE (canSaveComplex ("", error));
  EXPECT_FALSE (canSaveComplex (folder / "missing/file.ply", error));
  EXPECT_EQ ("cannot be written: there is no folder " + folder / "missing", error);
  fs::create_directory (folder / "folder.ply");
  EXPECT_FALSE (canSaveComplex (folder / "folder.ply", error));
  EXPECT_EQ ("cannot be written: it is a folder", error);
  EXPECT_FALSE (saveComplex (folder / "folder.ply", pointsXYZ (1), SimplicialComplex (), error));
  EXPECT_FALSE (saveComplex (folder / "missing/file.ply", pointsXYZ (1), SimplicialComplex (), error));
  EXPECT_FALSE (saveComplex (folder / "file.stl", pointsXYZ (1), SimplicialComplex (), error));
  EXPECT_TRUE (canSaveComplex (folder / "FILE.PLY", error)) << error;
  EXPECT_EQ (1, folder.count ());
}

TEST (ComplexIo, LinksAreFollowed)
{
  const TestFolder folder;
  std::string error;
  fs::create_symlink (folder / "real.ply", folder / "link.ply");
  ASSERT_TRUE (saveComplex (folder / "link.ply", pointsXYZ (1), SimplicialComplex (), error)) << error;
  EXPECT_TRUE (fs::is_symlink (folder / "link.ply"));
  EXPECT_TRUE (fs::is_regular_file (folder / "real.ply"));
}

TEST (ComplexIo, FilesThatCannotBeRead)
{
  const TestFolder folder;
  PCLPointCloud2 cloud;
  SimplicialComplex complex;
  std::string error;
  EXPECT_FALSE (loadComplex (folder / "missing.ply", cloud, complex, error));
  EXPECT_EQ ("cannot be read: No such file or directory", error);
  fs::create_directory (folder / "folder.vtu");
  EXPECT_FALSE (loadComplex (folder / "folder.vtu", cloud, complex, error));
  EXPECT_EQ ("cannot be read: it is a folder", error);
  EXPECT_FALSE (loadComplex (folder / "file.xyz", cloud, complex, error));
  EXPECT_EQ ("unknown extension .xyz; use .ply, .obj, .vtk or .vtu", error);
}

TEST (ComplexIo, FieldsThatPlyCannotWrite)
{
  const TestFolder folder;
  PCLPointCloud2 cloud =
    blankCloud ({{"x", PCLPointField::FLOAT32, 1}, {"stamp", PCLPointField::UINT64, 1}}, 2);
  std::string error;
  at<std::uint64_t> (cloud, "stamp", 1) = std::uint64_t (1) << 60;
  ASSERT_TRUE (saveComplex (folder / "a.ply", cloud, SimplicialComplex (), error)) << error;
  SimplicialComplex complex;
  PCLPointCloud2 read;
  ASSERT_TRUE (loadComplex (folder / "a.ply", read, complex, error)) << error;
  EXPECT_EQ (std::ldexp (1.0, 60), at<double> (read, "stamp", 1));
  at<std::uint64_t> (cloud, "stamp", 1) += 1;
  EXPECT_FALSE (saveComplex (folder / "b.ply", cloud, SimplicialComplex (), error));
  EXPECT_EQ (
    "PLY has no 64-bit integers and cannot write the 1152921504606846977 of the field stamp; write VTU",
    error);
  cloud.fields[1].name = "time stamp";
  EXPECT_FALSE (saveComplex (folder / "b.ply", cloud, SimplicialComplex (), error));
  EXPECT_EQ (1, folder.count ());
}

TEST (ComplexIo, VtkKeepsWideIntegersAndNamesWithBlanks)
{
  const TestFolder folder;
  PCLPointCloud2 cloud = pointsXYZ (2);
  cloud = blankCloud ({{"x", PCLPointField::FLOAT32, 1},
                       {"y", PCLPointField::FLOAT32, 1},
                       {"z", PCLPointField::FLOAT32, 1},
                       {"a <b> & \"c\" 100%", PCLPointField::UINT64, 1},
                       {"d", PCLPointField::INT64, 2}},
                      2);
  at<std::uint64_t> (cloud, cloud.fields[3].name, 1) = std::numeric_limits<std::uint64_t>::max ();
  at<std::int64_t> (cloud, "d", 1, 1) = std::numeric_limits<std::int64_t>::min ();
  for (const char* const extension : {".vtk", ".vtu"})
    for (const bool ascii : {false, true}) {
      const std::string file = folder / (std::string ("a") + extension);
      std::string error;
      ASSERT_TRUE (saveComplex (file, cloud, SimplicialComplex (), error, ascii)) << error;
      PCLPointCloud2 read;
      SimplicialComplex complex;
      ASSERT_TRUE (loadComplex (file, read, complex, error)) << error;
      for (const PCLPointField& field : cloud.fields)
        EXPECT_EQ (bytesOf (cloud, field.name), bytesOf (read, field.name)) << field.name;
    }
}

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

TEST (ComplexIo, PlyOfOthers)
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
  EXPECT_EQ (9, at<std::int16_t> (file.cloud, "even", 1, 1));
  EXPECT_EQ (0xff020103u, at<std::uint32_t> (file.cloud, "rgb", 2));
  EXPECT_EQ (1.f, at<float> (file.cloud, "x", 1));
}

TEST (ComplexIo, PlyBigEndian)
{
  std::string bytes =
    "ply\nformat binary_big_endian 1.0\nelement vertex 2\nproperty double x\nproperty short s\n"
    "element face 1\nproperty list ushort int vertex_indices\nend_header\n";
  bytes += std::string ("\x3f\xf0\0\0\0\0\0\0\x01\x02\x40\0\0\0\0\0\0\0\xff\xfe", 20);
  bytes += std::string ("\0\2\0\0\0\1\0\0\0\0", 10);
  Loaded file (".ply", bytes);
  ASSERT_TRUE (file.good) << file.error;
  EXPECT_EQ (1.0, at<double> (file.cloud, "x", 0));
  EXPECT_EQ (2.0, at<double> (file.cloud, "x", 1));
  EXPECT_EQ (0x102, at<std::int16_t> (file.cloud, "s", 0));
  EXPECT_EQ (-2, at<std::int16_t> (file.cloud, "s", 1));
  EXPECT_EQ ((std::vector<SimplicialComplex::Edge>{{1, 0}}), file.complex.edges);
}

TEST (ComplexIo, ObjOfOthers)
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
}

TEST (ComplexIo, VtkOfOthers)
{
  Loaded poly (
    ".vtk",
    "# vtk DataFile Version 3.0\nvtk output\nASCII\nDATASET POLYDATA\nPOINTS 5 float\n0 0 0 1 0 0\n"
    "1 1 0 0 1 0 0 0 1\nMETADATA\nINFORMATION 0\n\nVERTICES 1 2\n1 0\nLINES 1 4\n3 0 1 4\nPOLYGONS 1 5\n4 0 "
    "1 2 3\n"
    "TRIANGLE_STRIPS 1 5\n4 0 1 3 2\nCELL_DATA 4\nSCALARS s int\nLOOKUP_TABLE default\n1 2 3 4\n"
    "LOOKUP_TABLE t 1\n0 0 0 1\nPOINT_DATA 5\nSCALARS a%20b float 1\nLOOKUP_TABLE default\n1 2 3 4 5\n"
    "NORMALS n float\n0 0 1 0 0 1 0 0 1 0 0 1 0 0 1\nCOLOR_SCALARS rgb 3\n1 0 0 0 .5 0 0 0 1 1 1 1 0 0 0\n");
  ASSERT_TRUE (poly.good) << poly.error;
  EXPECT_EQ ((std::vector<SimplicialComplex::Edge>{{0, 1}, {1, 4}}), poly.complex.edges);
  EXPECT_EQ ((std::vector<SimplicialComplex::Triangle>{{0, 1, 2}, {0, 2, 3}, {0, 1, 3}, {1, 2, 3}}),
             poly.complex.triangles);
  EXPECT_EQ (4.f, at<float> (poly.cloud, "a b", 3));
  EXPECT_EQ (3u, fieldOf (poly.cloud, "n").count);
  EXPECT_EQ (0xff008000u, at<std::uint32_t> (poly.cloud, "rgb", 1));

  Loaded grid (
    ".vtk", "# vtk DataFile Version 5.1\nvtk output\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 double\n"
            "0 0 0 1 0 0 0 1 0 0 0 1\nCELLS 4 10\nOFFSETS vtktypeint64\n0 2 6 10\nCONNECTIVITY vtktypeint64\n"
            "0 1\n0 1 2 3\n0 1 2 3\nCELL_TYPES 3\n3\n8\n10\n");
  ASSERT_TRUE (grid.good) << grid.error;
  EXPECT_EQ ((std::vector<SimplicialComplex::Triangle>{{0, 1, 3}, {0, 3, 2}}), grid.complex.triangles);
  EXPECT_EQ ((std::vector<SimplicialComplex::Tetrahedron>{{0, 1, 2, 3}}), grid.complex.tetrahedra);
}

struct WrongFile
{
  const char* extension;
  std::string bytes;
  const char* error;
};

TEST (ComplexIo, WhatIsWrongAndWhere)
{
  const std::string ply = "ply\nformat ascii 1.0\n", le = "ply\nformat binary_little_endian 1.0\n";
  const std::string vertices = "element vertex 2\nproperty float x\nproperty float y\nproperty float z\n";
  const std::string faces = "element face 1\nproperty list char int vertex_indices\n";
  const std::string vtk =
    "# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 1 float\n0 0 0\n";
  const std::string vtu = "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" "
                          "header_type=\"UInt64\">\n<UnstructuredGrid>\n"
                          "<Piece NumberOfPoints=\"1\" NumberOfCells=\"0\">\n<Points>\n";
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
    {".vtk", "", "line 1: not a legacy VTK file"},
    {".vtk", "# vtk DataFile Version 3.0\nt\nASCII\nDATASET STRUCTURED_POINTS\n",
     "line 4: expected UNSTRUCTURED_GRID or POLYDATA, found 'structured_points'"},
    {".vtk", "# vtk DataFile Version 3.0\nt\nBINARY\nDATASET POLYDATA\nPOINTS 1000000000000 float\n",
     "line 5: more values than the file can hold"},
    {".vtk", "# vtk DataFile Version 3.0\nt\nBINARY\nDATASET POLYDATA\nPOINTS 1 bit\n",
     "line 5: expected a type of numbers, found 'bit'"},
    {".vtk", vtk + "CELLS 1 3\n2 0 1\nCELL_TYPES 1\n3\n", "cell 0 has point 1, which there is not"},
    {".vtk", vtk + "CELLS 1 3\n7 0 1\nCELL_TYPES 1\n3\n", "line 8: cell 0 is outside of the list of cells"},
    {".vtk", vtk + "CELLS 1 2\n1 0\nCELL_TYPES 1\n12\n",
     "cell 0 of type 12 is no point, line, polygon or tetrahedron"},
    {".vtk", vtk + "CELLS 1 2\n1 0\n", "1 cells, but 0 cell types"},
    {".vtk", vtk + "POINT_DATA 2\nSCALARS s int\nLOOKUP_TABLE default\n1 2\n",
     "the array 's' has not one entry a point"},
    {".vtk", vtk + "NONSENSE\n", "line 7: expected a section of a VTK file, found 'nonsense'"},
    {".vtu", "", "line 1: not a VTK file"},
    {".vtu", "<VTKFile type=\"PolyData\">\n", "line 1: no unstructured grid but 'PolyData'"},
    {".vtu", "<VTKFile type=\"UnstructuredGrid\" compressor=\"vtkLZ4DataCompressor\">\n",
     "line 1: compressed by 'vtkLZ4DataCompressor', which cannot be read"},
    {".vtu", "<VTKFile type=\"UnstructuredGrid\">\n</VTKFile>", "the file has no piece of a grid"},
    {".vtu", vtu + "<DataArray", "line 6: the tag has no end"},
    {".vtu", vtu + "<DataArray type=Float32>", "line 6: an attribute without a value in quotes"},
    {".vtu",
     vtu +
       "<DataArray type=\"Float32\" Name=\"P\" NumberOfComponents=\"3\" format=\"ascii\">0 0 O</DataArray>",
     "array 'P': expected a number, found 'O'"},
    {".vtu",
     vtu + "<DataArray type=\"Float32\" Name=\"P\" NumberOfComponents=\"2\" format=\"ascii\">0 0</DataArray>",
     "the points do not have three coordinates each"},
    {".vtu",
     vtu + "<DataArray type=\"Float32\" Name=\"P\" NumberOfComponents=\"3\" "
           "format=\"binary\">////////</DataArray>",
     "array 'P': the file ends too early"},
    {".vtu",
     vtu + "<DataArray type=\"Float32\" Name=\"P\" NumberOfComponents=\"3\" "
           "format=\"binary\">/////////////w==</DataArray>",
     "array 'P': an array of 18446744073709551615 bytes, more than the file has"},
    {".vtu",
     vtu +
       "<DataArray type=\"Float32\" Name=\"P\" NumberOfComponents=\"3\" format=\"appended\" offset=\"9\"/>",
     "array 'P': its data are not in the file"},
  };
  for (const WrongFile& wrong : files) {
    const Loaded file (wrong.extension, wrong.bytes);
    EXPECT_FALSE (file.good) << wrong.error;
    EXPECT_EQ (wrong.error, file.error) << wrong.bytes;
    EXPECT_TRUE (file.complex.empty ());
    EXPECT_EQ (0u, file.cloud.width);
  }
}

TEST (ComplexIo, PclReadsOurPly)
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
  SimplicialComplex complex = mixedComplex ();
  complex.edges.clear ();
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

TEST (ComplexIo, PclReadsOurObj)
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

TEST (ComplexIo, OursReadsPclsPly)
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
