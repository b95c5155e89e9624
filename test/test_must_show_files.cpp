// Real clouds. They are no part of the sources: a test whose file is absent is skipped. They are looked for
// in the folder that the environment variable PCL_MANIFOLD_DATA names and in libcgal-demo of Debian.
#include "test_must_show_fixed_points.h"

#include <cloud_reader.h>

#include <gtest/gtest.h>
#include <pcl/conversions.h>
#include <pcl/manifold/dimension_detection.h>
#include <pcl/manifold/fixed_point_reconstruction.h>
#include <pcl/manifold/graph_reconstruction.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

namespace {

using must_show::Evaluation;

/** A file of the data folder, or an empty name. */
std::string
dataFile (const std::string& name)
{
  const char* folder = std::getenv ("PCL_MANIFOLD_DATA");
  const auto file = std::filesystem::path (folder != nullptr ? folder : PCL_MANIFOLD_DATA_DEFAULT) / name;
  return std::filesystem::exists (file) ? file.string () : std::string ();
}

/** libcgal-demo's data, unpacked once and removed at the end. */
class DemoData : public testing::Environment
{
public:
  static std::string file (const std::string& name)
  {
    const std::string archive = "/usr/share/doc/libcgal-dev/data.tar.gz";
    if (!std::filesystem::exists (archive))
      return {};
    if (folder ().empty ()) {
      std::string made = (std::filesystem::temp_directory_path () / "demo_data_XXXXXX").string ();
      if (mkdtemp (made.data ()) == nullptr)
        return {};
      folder () = made;
      const std::string command = "tar -xzf " + archive + " -C '" + made + "' data/meshes data/points_3";
      if (std::system (command.c_str ()) != 0)
        return {};
    }
    const auto found = std::filesystem::path (folder ()) / "data" / name;
    return std::filesystem::exists (found) ? found.string () : std::string ();
  }

  void TearDown () override
  {
    std::error_code ignored;
    if (!folder ().empty ())
      std::filesystem::remove_all (folder (), ignored);
  }

private:
  static std::string& folder ()
  {
    static std::string name;
    return name;
  }
};

const testing::Environment* const demo_data = testing::AddGlobalTestEnvironment (new DemoData);

template <typename PointT>
typename pcl::PointCloud<PointT>::Ptr
readCloud (const std::string& file)
{
  const auto cloud = std::make_shared<pcl::PointCloud<PointT>> ();
  pcl::fromPCLPointCloud2 (pcl::manifold::apps::readCloud (file).cloud, *cloud);
  return cloud;
}

Eigen::Matrix3Xd
readPoints (const std::string& file)
{
  const auto cloud = readCloud<pcl::PointXYZ> (file);
  return cloud->getMatrixXfMap (3, 4, 0).cast<double> ();
}

/** Reconstructs a file, open and watertight. */
void
expectShape (const std::string& file, const must_show::Expected& expected, double watertight_used)
{
  const Eigen::Matrix3Xd points = readPoints (file);
  const Evaluation open = must_show::reconstruct (points, false);
  EXPECT_EQ (open.complaints (expected), "");
  const Evaluation watertight = must_show::reconstruct (points, true, open.dimensions);
  EXPECT_EQ (watertight.complaints (must_show::closed (expected.euler, watertight_used)), "") << "watertight";
}

struct DemoModel
{
  const char* name;
  const char* file;
  int euler;
};

class DemoMesh : public testing::TestWithParam<DemoModel>
{};

TEST_P (DemoMesh, IsClosedOnAllVertices)
{
  const std::string file = DemoData::file (GetParam ().file);
  if (file.empty ())
    GTEST_SKIP () << GetParam ().file << " of libcgal-demo is not installed";
  must_show::Expected expected = must_show::closed (GetParam ().euler, 1.0);
  expected.one_piece = true;
  expectShape (file, expected, 0.998);
}

TEST_P (DemoMesh, IsClosedByFixedPoints)
{
  const std::string file = DemoData::file (GetParam ().file);
  if (file.empty ())
    GTEST_SKIP () << GetParam ().file << " of libcgal-demo is not installed";
  must_show::Expected expected = must_show::closed (GetParam ().euler, 1.0);
  expected.one_piece = true;
  pcl::FixedPointReconstruction<pcl::PointXYZ> defaults;
  const must_show::FixedPointEvaluation evaluation = must_show::reconstructFixedPoint (
    readPoints (file), {defaults.getCriticalRatio (), defaults.getVotes ()});
  EXPECT_EQ (evaluation.surface.complaints (expected), "");
}

TEST_P (DemoMesh, HasItsGenusByGraphDistances)
{
  const std::string file = DemoData::file (GetParam ().file);
  if (file.empty ())
    GTEST_SKIP () << GetParam ().file << " of libcgal-demo is not installed";
  pcl::GraphReconstruction<pcl::PointXYZ> reconstruction;
  reconstruction.setInputCloud (readCloud<pcl::PointXYZ> (file));
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
    for (const int hops : {3, 5}) {
      SCOPED_TRACE (std::to_string (hops) + " hops, seed " + std::to_string (seed));
      reconstruction.setSeed (seed);
      reconstruction.setHops (hops);
      std::vector<pcl::Vertices> polygons;
      reconstruction.reconstruct (polygons);
      ASSERT_EQ (reconstruction.getStatus (), pcl::manifold::Status::OK);
      const pcl::TopologyReport& report = reconstruction.getReport ();
      EXPECT_EQ (report.surface.components.size (), 1U);
      EXPECT_EQ (report.surface.euler_characteristic, GetParam ().euler);
      EXPECT_EQ (report.curve.edges, 0U);
      EXPECT_EQ (report.surface.inner_edges, report.surface.edges);
      EXPECT_TRUE (report.surface.isOrientable ());
      pcl::SimplicialComplex written;
      for (const pcl::Vertices& polygon : polygons)
        written.triangles.push_back ({polygon.vertices[0], polygon.vertices[1], polygon.vertices[2]});
      const pcl::manifold::SurfaceTopology surface = pcl::manifold::analyze (written).surface;
      EXPECT_TRUE (surface.isManifold ());
      EXPECT_EQ (surface.euler_characteristic, GetParam ().euler);
    }
}

INSTANTIATE_TEST_SUITE_P (Files, DemoMesh,
                          testing::Values (DemoModel{"knot1", "meshes/knot1.off", 0},
                                           DemoModel{"kitten", "points_3/kitten.xyz", 0},
                                           DemoModel{"bunny00", "meshes/bunny00.off", 2}),
                          [] (const auto& tested) { return tested.param.name; });

TEST (ScannedMesh, BunnyKeepsItsHoles)
{
  const std::string file = dataFile ("bunny_35947.pcd");
  if (file.empty ())
    GTEST_SKIP () << "no bunny_35947.pcd";
  must_show::Expected expected;
  expected.most_loops = 2;
  expected.orientable = true;
  expected.used = 0.999;
  expectShape (file, expected, 0.998);
}

TEST (ScannedMesh, DragonKeepsItsHoles)
{
  const std::string file = dataFile ("dragon_435545.pcd");
  if (file.empty ())
    GTEST_SKIP () << "no dragon_435545.pcd";
  must_show::Expected expected;
  expected.most_loops = 8; // the best of the peers leaves 817
  expected.orientable = true;
  expected.used = 0.99;
  expectShape (file, expected, 0.998);
}

TEST (AirborneScan, WiresAreFound)
{
  constexpr std::uint32_t WIRE = 14;
  const std::string file = dataFile ("ahn_12AN2_20.pcd");
  if (file.empty ())
    GTEST_SKIP () << "no ahn_12AN2_20.pcd";
  const auto cloud = readCloud<pcl::PointXYZL> (file);
  pcl::DimensionDetection<pcl::PointXYZL> detection;
  detection.setInputCloud (cloud);
  double best = 0.0;
  for (int k = 4; k <= 8; ++k) {
    detection.setKSearch (k);
    pcl::PointCloud<pcl::Label> labels;
    detection.compute (labels);
    const std::vector<std::uint8_t> dimension = detection.getManifoldDimension ();
    ASSERT_EQ (dimension.size (), cloud->size ());
    double hits = 0.0;
    double wires = 0.0;
    double found = 0.0;
    for (std::size_t i = 0; i < dimension.size (); ++i) {
      const bool is_wire = (*cloud)[i].label == WIRE;
      wires += is_wire;
      found += dimension[i] == 1;
      hits += is_wire && dimension[i] == 1;
    }
    const double f1 = 2.0 * hits / (wires + found);
    std::printf ("k = %d: recall %.3f, precision %.3f, F1 %.3f\n", k, hits / wires, hits / found, f1);
    best = std::max (best, f1);
  }
  EXPECT_GE (best, 0.90);
}

} // namespace
