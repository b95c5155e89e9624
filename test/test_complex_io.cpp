#include "test_apps_folder.h"
#include "test_complex_io_clouds.h"

#include <pcl/manifold/complex_io.h>

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
using pcl::manifold::canSaveComplex;
using pcl::manifold::isValid;
using pcl::manifold::loadComplex;
using pcl::manifold::saveComplex;

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
  put<std::uint32_t> (cloud, "rgba", 5, 0, 0x12345678);
  put<std::uint8_t> (cloud, "seen", 4, 0, 1);
  roundTrip (cloud, SimplicialComplex ());
  if (isObj ())
    return;
  EXPECT_EQ (5u, cloud_.fields.size ());
  EXPECT_EQ (0x12345678u, get<std::uint32_t> (cloud_, "rgba", 5));
  EXPECT_EQ (1, get<std::uint8_t> (cloud_, "seen", 4));
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
  put<std::uint64_t> (cloud, "stamp", 1, 0, std::uint64_t (1) << 60);
  ASSERT_TRUE (saveComplex (folder / "a.ply", cloud, SimplicialComplex (), error)) << error;
  SimplicialComplex complex;
  PCLPointCloud2 read;
  ASSERT_TRUE (loadComplex (folder / "a.ply", read, complex, error)) << error;
  EXPECT_EQ (std::ldexp (1.0, 60), get<double> (read, "stamp", 1));
  put<std::uint64_t> (cloud, "stamp", 1, 0, get<std::uint64_t> (cloud, "stamp", 1) + 1);
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
  put<std::uint64_t> (cloud, cloud.fields[3].name, 1, 0, std::numeric_limits<std::uint64_t>::max ());
  put<std::int64_t> (cloud, "d", 1, 1, std::numeric_limits<std::int64_t>::min ());
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

} // namespace
