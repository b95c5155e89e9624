#pragma once

#include "test_class_contract.h"

#include <pcl/conversions.h>
#include <pcl/manifold/fixed_point_reconstruction.h>
#include <pcl/manifold/topology_report.h>

#include <algorithm>
#include <array>
#include <memory>
#include <set>
#include <vector>

/** FixedPointReconstruction as its tests run it. */
namespace fixed_point_runs {

using namespace class_contract;
using Triangle = pcl::SimplicialComplex::Triangle;

template <typename PointT>
bool
givesNothing (const pcl::FixedPointReconstruction<PointT>& object)
{
  const pcl::manifold::FixedPointCounts counts = object.getCounts ();
  return object.getComplex ().empty () && object.getIterations () == 0 && counts.anchored == 0 &&
         counts.medial == 0 && counts.chained == 0 && object.getDelaunayComplex () == nullptr;
}

/** As a complex. */
struct Reconstruction
{
  pcl::FixedPointReconstruction<pcl::PointXYZ> object;
  pcl::SimplicialComplex surface;

  bool operator() ()
  {
    object.reconstruct (surface);
    EXPECT_TRUE (surface.edges.empty ());
    EXPECT_TRUE (surface.tetrahedra.empty ());
    return surface.empty () && givesNothing (object);
  }
};

/** Through the base class, as a mesh. */
struct MeshReconstruction
{
  pcl::FixedPointReconstruction<pcl::PointXYZ> object;
  pcl::PolygonMesh mesh;

  bool operator() ()
  {
    static_cast<pcl::MeshConstruction<pcl::PointXYZ>&> (object).reconstruct (mesh);
    return mesh.polygons.empty () && mesh.cloud.data.empty () && givesNothing (object);
  }
};

/** From the mesh that the torus of torusAndKnot () has, moved a little. */
struct InitialMeshReconstruction : Reconstruction
{
  InitialMeshReconstruction ();
};

inline std::vector<Eigen::Vector3f>
torusPoints (double spacing = 0.09, std::uint64_t seed = 1)
{
  return floats (generate::blueNoise (generate::torus (), spacing, seed));
}

inline std::shared_ptr<Reconstruction>
reconstruct (const std::vector<Eigen::Vector3f>& points, const pcl::PolygonMesh::ConstPtr& initial = nullptr,
             unsigned int threads = 1, int k = 0)
{
  const auto run = std::make_shared<Reconstruction> ();
  run->object.setInputCloud (cloudOf (points));
  run->object.setInitialMesh (initial);
  run->object.setNumberOfThreads (threads);
  run->object.setThinningNeighbors (k);
  (*run) ();
  EXPECT_EQ (run->object.getStatus (), Status::OK);
  return run;
}

/** A mesh of triangles over points. */
inline pcl::PolygonMesh::Ptr
meshOf (const std::vector<Eigen::Vector3f>& points, const std::vector<Triangle>& triangles)
{
  const auto mesh = std::make_shared<pcl::PolygonMesh> ();
  pcl::toPCLPointCloud2 (*cloudOf (points), mesh->cloud);
  for (const Triangle& triangle : triangles) {
    mesh->polygons.emplace_back ();
    mesh->polygons.back ().vertices.assign (triangle.begin (), triangle.end ());
  }
  return mesh;
}

/** A coarse mesh of the torus, over other points than those of torusPoints (). */
inline pcl::PolygonMesh::Ptr
coarseTorus ()
{
  const std::vector<Eigen::Vector3f> points = torusPoints (0.2, 7);
  return meshOf (points, reconstruct (points)->surface.triangles);
}

inline InitialMeshReconstruction::InitialMeshReconstruction ()
{
  object.setInitialMesh (coarseTorus ());
}

/** The sets of vertices of triangles, renumbered if there are numbers. */
inline std::set<Triangle>
sorted (std::vector<Triangle> triangles, const std::vector<int>& number = {})
{
  for (Triangle& triangle : triangles) {
    for (pcl::index_t& vertex : triangle)
      if (!number.empty ())
        vertex = number[static_cast<std::size_t> (vertex)];
    std::sort (triangle.begin (), triangle.end ());
  }
  return {triangles.begin (), triangles.end ()};
}

/** Fails unless the surface is one closed, oriented torus over all points. */
inline void
expectTorus (const pcl::SimplicialComplex& surface, std::size_t points)
{
  const pcl::manifold::SurfaceTopology topology = pcl::manifold::analyze (surface).surface;
  EXPECT_TRUE (topology.isManifold ());
  EXPECT_TRUE (topology.isClosed ());
  EXPECT_EQ (topology.vertices, points);
  ASSERT_EQ (topology.components.size (), 1U);
  EXPECT_TRUE (topology.components[0].orientable);
  EXPECT_EQ (topology.components[0].genus, 1);
  // Every edge is walked once in each direction.
  std::set<std::array<pcl::index_t, 2>> walked;
  for (const Triangle& triangle : surface.triangles)
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_TRUE (walked.insert ({triangle[i], triangle[(i + 1) % 3]}).second);
}

} // namespace fixed_point_runs
