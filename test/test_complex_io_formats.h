#pragma once

#include "test_apps_folder.h"
#include "test_complex_io_clouds.h"

#include <pcl/manifold/complex_io.h>

#include <gtest/gtest.h>

#include <cstring>
#include <limits>

#include <csignal>
#include <sys/resource.h>

/** What every format keeps to that complexes are written in. Each test file that includes this says which
 * formats, and what reads them: our own readers or those of others. */
namespace complex_io_formats {

using pcl::manifold::saveComplex;

using Loader = bool (*) (const std::string& file, PCLPointCloud2& cloud, SimplicialComplex& complex,
                         std::string& error);

struct FormatCase
{
  const char* extension;
  bool ascii;
  Loader load;
};

inline std::string
nameOf (const testing::TestParamInfo<FormatCase>& test)
{
  return std::string (test.param.extension + 1) + (test.param.ascii ? "_ascii" : "_binary");
}

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
    ASSERT_TRUE (GetParam ().load (file_, cloud_, complex_, error)) << error;
    EXPECT_EQ (cloud.width * cloud.height, cloud_.width * cloud_.height);
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
  if (isVtk () && GetParam ().ascii) { // VTK reads no such text, though it writes it
    save (cloud, SimplicialComplex ());
    EXPECT_TRUE (contains (folder_.read (name_),
                           "\nnan inf -inf\n3.4028235e+38 1.1754944e-38 1e-45\n-0 0.1 -1.1920929e-07\n"));
    return;
  }
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

} // namespace complex_io_formats
