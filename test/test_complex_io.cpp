#include "test_complex_io_formats.h"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <random>

#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

namespace fs = std::filesystem;
using namespace complex_io_formats;
using pcl::manifold::canSaveComplex;
using pcl::manifold::isValid;
using pcl::manifold::loadComplex;

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
                          testing::Values (FormatCase{".ply", false, loadComplex},
                                           FormatCase{".ply", true, loadComplex},
                                           FormatCase{".obj", true, loadComplex}),
                          nameOf);

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
  fs::create_directory (folder / "folder.obj");
  EXPECT_FALSE (loadComplex (folder / "folder.obj", cloud, complex, error));
  EXPECT_EQ ("cannot be read: it is a folder", error);
  EXPECT_FALSE (loadComplex (folder / "file.xyz", cloud, complex, error));
  EXPECT_EQ ("unknown extension .xyz; use .ply or .obj", error);
  ASSERT_TRUE (saveComplex (folder / "mesh.vtk", pointsXYZ (10), mixedComplex (), error));
  EXPECT_FALSE (loadComplex (folder / "mesh.vtk", cloud, complex, error));
  EXPECT_EQ (".vtk is written only; use .ply or .obj", error);
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

} // namespace
