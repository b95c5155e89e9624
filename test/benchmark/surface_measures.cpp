#include "surface_measures.h"

#include <generate/sampling.h>
#include <mesh_distance.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace benchmark {

namespace {

using Triangle = pcl::SimplicialComplex::Triangle;
using pcl::manifold::apps::TriangleMesh;

/** \brief In degrees. */
double
smallestAngle (const Eigen::Matrix3Xd& points, const Triangle& triangle)
{
  double smallest = M_PI;
  for (std::size_t i = 0; i < 3; ++i) {
    const Eigen::Vector3d at = points.col (triangle[i]);
    const Eigen::Vector3d a = points.col (triangle[(i + 1) % 3]) - at;
    const Eigen::Vector3d b = points.col (triangle[(i + 2) % 3]) - at;
    smallest = std::min (smallest, std::atan2 (a.cross (b).norm (), a.dot (b)));
  }
  return smallest * 180.0 / M_PI;
}

/** \brief The largest distance of the mesh from the shape and of the shape from the mesh, at many places. */
double
hausdorff (const TriangleMesh& mesh, const generate::Shape& shape)
{
  const Eigen::Matrix3Xd on_mesh = pcl::manifold::apps::placesOn (mesh, meanEdge (mesh));
  double largest = 0.0;
  for (const auto& place : on_mesh.colwise ())
    largest = std::max (largest, shape.nearest (place).distance);
  const generate::LabelledCloud drawn = generate::uniform (shape, 5 * mesh.triangles.size (), 1);
  Eigen::Matrix3Xd places (3, static_cast<Eigen::Index> (drawn.size ()));
  for (std::size_t i = 0; i < drawn.size (); ++i)
    places.col (static_cast<Eigen::Index> (i)) = drawn.points[i];
  return std::max (largest, pcl::manifold::apps::largestDistance (places, mesh));
}

} // namespace

SurfaceMeasures
measure (const std::vector<Triangle>& triangles, const Eigen::Matrix3Xd& points, const generate::Shape* shape)
{
  SurfaceMeasures result;
  pcl::SimplicialComplex complex;
  complex.triangles = triangles;
  result.topology = pcl::manifold::analyze (complex).surface;
  result.hausdorff = shape != nullptr && !triangles.empty () ? hausdorff ({points, triangles}, *shape) : -1.0;
  if (triangles.empty ())
    return result;
  std::vector<double> angles;
  for (const Triangle& triangle : triangles)
    angles.push_back (smallestAngle (points, triangle));
  std::sort (angles.begin (), angles.end ());
  result.smallest_angle = angles.front ();
  result.percentile_angle = angles[angles.size () / 100];
  return result;
}

} // namespace benchmark
