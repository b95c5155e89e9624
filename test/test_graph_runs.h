#pragma once

#include "test_class_contract.h"

#include <pcl/manifold/graph_reconstruction.h>

#include <algorithm>
#include <memory>
#include <set>
#include <vector>

/** GraphReconstruction as its tests run it. */
namespace graph_runs {

using namespace class_contract;

template <typename PointT>
bool
givesNothing (const pcl::GraphReconstruction<PointT>& object)
{
  return object.getLandmarks ().empty () && object.getTiles ().empty () && object.getAdjacency ().empty () &&
         object.getLandmarkMesh ().edges.empty () && object.getLandmarkMesh ().faces.empty () &&
         object.getReport ().vertices == 0 && object.getNeighborhoodGraph ().size () == 0 &&
         object.getVertices ().empty ();
}

/** One surface and nothing else, closed, with two sides. */
inline void
expectClosedOfGenus (const pcl::TopologyReport& report, int genus)
{
  EXPECT_EQ (report.curve.edges, 0U);
  ASSERT_EQ (report.surface.components.size (), 1U);
  EXPECT_EQ (report.surface.inner_edges, report.surface.edges);
  EXPECT_TRUE (report.surface.isOrientable ());
  EXPECT_EQ (report.surface.components[0].genus, genus);
}

/** Polygons only; landmarks near enough to each other for small clouds. */
template <typename PointT>
struct ReconstructionOf
{
  pcl::GraphReconstruction<PointT> object;
  std::vector<pcl::Vertices> polygons;

  ReconstructionOf () { object.setHops (3); }

  bool operator() ()
  {
    object.reconstruct (polygons);
    return polygons.empty () && givesNothing (object);
  }
};

using Reconstruction = ReconstructionOf<pcl::PointXYZ>;

/** Through the base class, as a mesh. */
struct MeshReconstruction
{
  pcl::GraphReconstruction<pcl::PointXYZ> object;
  pcl::PolygonMesh mesh;

  MeshReconstruction () { object.setHops (3); }

  bool operator() ()
  {
    static_cast<pcl::MeshConstruction<pcl::PointXYZ>&> (object).reconstruct (mesh);
    return mesh.polygons.empty () && mesh.cloud.data.empty () && givesNothing (object);
  }
};

/** The vertices of all polygons, each from its smallest vertex on, in the same direction, renumbered. */
inline std::multiset<pcl::Indices>
faces (const std::vector<pcl::Vertices>& polygons, const std::vector<int>& number = {})
{
  std::multiset<pcl::Indices> result;
  for (const pcl::Vertices& polygon : polygons) {
    pcl::Indices face = polygon.vertices;
    if (!number.empty ())
      for (pcl::index_t& vertex : face)
        vertex = number[static_cast<std::size_t> (vertex)];
    std::rotate (face.begin (), std::min_element (face.begin (), face.end ()), face.end ());
    result.insert (face);
  }
  return result;
}

/** About so many points spread evenly over a shape of the catalogue. */
inline std::vector<Eigen::Vector3f>
evenly (const std::string& name, std::size_t points, std::uint64_t seed = 1)
{
  const generate::Shape shape = generate::shapeByName (name);
  return floats (generate::blueNoise (shape, generate::spacingFor (shape, points), seed));
}

inline std::vector<Eigen::Vector3f>
shuffledBy (const std::vector<int>& order, const std::vector<Eigen::Vector3f>& points)
{
  std::vector<Eigen::Vector3f> shuffled;
  for (const int i : order)
    shuffled.push_back (points[static_cast<std::size_t> (i)]);
  return shuffled;
}

/** The graph of the nearest neighbours of points, numbered as they are. */
inline std::shared_ptr<const pcl::manifold::NeighborhoodGraph>
graphOf (const std::vector<Eigen::Vector3f>& points, int k = 15)
{
  Eigen::MatrixXd matrix (3, static_cast<Eigen::Index> (points.size ()));
  for (std::size_t i = 0; i < points.size (); ++i)
    matrix.col (static_cast<Eigen::Index> (i)) = points[i].cast<double> ();
  auto graph = std::make_shared<pcl::manifold::NeighborhoodGraph> ();
  EXPECT_EQ (pcl::manifold::nearestNeighborGraph (matrix, k, 1, *graph), Status::OK);
  return graph;
}

} // namespace graph_runs
