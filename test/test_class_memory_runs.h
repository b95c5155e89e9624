#pragma once

#include "test_class_clouds.h"

#include <gtest/gtest.h>
#include <pcl/console/print.h>
#include <pcl/manifold/cocone_shape.h>
#include <pcl/manifold/dimension_detection.h>
#include <pcl/manifold/fixed_point_reconstruction.h>
#include <pcl/manifold/graph_reconstruction.h>

#include <memory>
#include <vector>

/** The classes as they are run where memory runs out. */
namespace class_memory {

using namespace class_clouds;
using pcl::manifold::Status;

inline std::vector<pcl::Indices>
indicesOf (const pcl::PolygonMesh& mesh)
{
  std::vector<pcl::Indices> polygons;
  for (const pcl::Vertices& polygon : mesh.polygons)
    polygons.push_back (polygon.vertices);
  return polygons;
}

struct Detection
{
  pcl::DimensionDetection<pcl::PointXYZ> object;
  pcl::PointCloud<pcl::Label> labels;

  void compute () { object.compute (labels); }

  bool givesNothing () const { return labels.empty () && object.getSampleDimensions () == nullptr; }

  std::vector<std::uint32_t> result () const
  {
    std::vector<std::uint32_t> values;
    for (const pcl::Label& label : labels)
      values.push_back (label.label);
    return values;
  }
};

template <typename Class>
struct Meshing
{
  Class object;
  pcl::PolygonMesh mesh;

  void compute () { object.reconstruct (mesh); }

  bool givesNothing () const { return mesh.polygons.empty () && mesh.cloud.data.empty (); }

  std::vector<pcl::Indices> result () const { return indicesOf (mesh); }
};

using Shape = Meshing<pcl::CoconeShape<pcl::PointXYZ>>;
using FixedPoint = Meshing<pcl::FixedPointReconstruction<pcl::PointXYZ>>;

struct Graph : Meshing<pcl::GraphReconstruction<pcl::PointXYZ>>
{
  Graph () { object.setHops (3); }

  bool givesNothing () const { return Meshing::givesNothing () && object.getLandmarks ().empty (); }
};

/** From a mesh, which is converted, too. */
struct FixedPointOfMesh : FixedPoint
{
  FixedPointOfMesh () { object.setInitialMesh (start ()); }

  static pcl::PolygonMesh::ConstPtr start ()
  {
    static const pcl::PolygonMesh::ConstPtr mesh = [] {
      FixedPoint run;
      run.object.setInputCloud (cloudOf (torusAndKnot (2)));
      run.compute ();
      return std::make_shared<pcl::PolygonMesh> (run.mesh);
    }();
    return mesh;
  }
};

template <typename Run>
class OutOfMemory : public testing::Test
{
protected:
  // A message for each failure would hide the one that counts.
  OutOfMemory () { pcl::console::setVerbosityLevel (pcl::console::L_ALWAYS); }
};

using Runs = testing::Types<Detection, Shape, FixedPoint, FixedPointOfMesh, Graph>;

} // namespace class_memory
