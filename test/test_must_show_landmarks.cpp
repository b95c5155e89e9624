// What README says of the landmark mesh on real clouds.
#include "real_data.h"

#include <gtest/gtest.h>
#include <pcl/manifold/fixed_point_reconstruction.h>
#include <pcl/manifold/graph_reconstruction.h>
#include <pcl/manifold/topology_report.h>

#include <memory>
#include <vector>

namespace {

using pcl::manifold::Status;
using pcl::manifold::SurfaceTopology;

TEST (PublishedFaces, GiveTheBunnyItsGenus)
{
  const std::string file = real_data::dataFile ("bunny_35947.pcd");
  if (file.empty ())
    GTEST_SKIP () << "no bunny_35947.pcd";
  pcl::GraphReconstruction<pcl::PointXYZ> reconstruction;
  reconstruction.setInputCloud (real_data::readCloud<pcl::PointXYZ> (file));
  reconstruction.setHops (5);
  reconstruction.setAdjacencyThreshold (7);
  reconstruction.setFaceRule (pcl::manifold::FaceRule::SHORTEST_CYCLES);
  reconstruction.setRefine (false);
  std::vector<pcl::Vertices> polygons;
  reconstruction.reconstruct (polygons);
  ASSERT_EQ (reconstruction.getStatus (), Status::OK);
  const pcl::TopologyReport& report = reconstruction.getReport ();
  EXPECT_EQ (static_cast<std::int64_t> (report.vertices + report.surface.faces) -
               static_cast<std::int64_t> (report.curve.edges + report.surface.edges),
             2); // genus 0 by the formula of the paper
}

TEST (Landmarks, LeadToAClosedMeshOfAllPoints)
{
  const std::string file = real_data::demoFile ("meshes/bunny00.off");
  if (file.empty ())
    GTEST_SKIP () << "bunny00.off of libcgal-demo is not there";
  const auto cloud = real_data::readCloud<pcl::PointXYZ> (file);
  pcl::GraphReconstruction<pcl::PointXYZ> landmarks;
  landmarks.setInputCloud (cloud);
  landmarks.setHops (3);
  const auto coarse = std::make_shared<pcl::PolygonMesh> ();
  landmarks.reconstruct (*coarse);
  ASSERT_EQ (landmarks.getStatus (), Status::OK);

  pcl::FixedPointReconstruction<pcl::PointXYZ> reconstruction;
  reconstruction.setInputCloud (cloud);
  reconstruction.setInitialMesh (coarse);
  pcl::SimplicialComplex mesh;
  reconstruction.reconstruct (mesh);
  ASSERT_EQ (reconstruction.getStatus (), Status::OK);
  const SurfaceTopology surface = pcl::manifold::analyze (mesh).surface;
  EXPECT_EQ (reconstruction.getIterations (), 3);
  EXPECT_TRUE (surface.isClosed ());
  EXPECT_TRUE (surface.isManifold ());
  EXPECT_EQ (surface.vertices, cloud->size ());
  EXPECT_EQ (surface.euler_characteristic, 2);
}

} // namespace
