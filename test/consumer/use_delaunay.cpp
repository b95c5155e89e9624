/** \file
 * A user's program that links pcl_manifold::delaunay. It compiles without CGAL. */
#include <pcl/manifold/cocone_shape.h>
#include <pcl/manifold/delaunay_complex.h>
#include <pcl/manifold/topology_report.h>

#include <cmath>
#include <iostream>

namespace {

/** A point type of the user's own, without PCL_NO_PRECOMPILE. */
struct SonarPoint
{
  PCL_ADD_POINT4D;
  float echo;
  PCL_MAKE_ALIGNED_OPERATOR_NEW
};

} // namespace

POINT_CLOUD_REGISTER_POINT_STRUCT (SonarPoint, (float, x, x) (float, y, y) (float, z, z) (float, echo, echo))

namespace {

/** Whether the points of a sphere come out as a sphere. */
bool
meshesSphere ()
{
  constexpr int POINTS = 500;
  const auto cloud = pcl::make_shared<pcl::PointCloud<SonarPoint>> ();
  for (int i = 0; i < POINTS; ++i) {
    const double z = 1.0 - (2.0 * i + 1.0) / POINTS;
    const double radius = std::sqrt (1.0 - z * z);
    SonarPoint point;
    point.x = static_cast<float> (radius * std::cos (2.399963 * i));
    point.y = static_cast<float> (radius * std::sin (2.399963 * i));
    point.z = static_cast<float> (z);
    cloud->push_back (point);
  }
  pcl::CoconeShape<SonarPoint> reconstruction;
  reconstruction.setInputCloud (cloud);
  pcl::SimplicialComplex shape;
  reconstruction.reconstruct (shape);
  const pcl::manifold::SurfaceTopology surface = pcl::manifold::analyze (shape).surface;
  return surface.isClosed () && surface.euler_characteristic == 2;
}

} // namespace

int
main ()
{
  const auto samples = std::make_shared<pcl::manifold::SampleSet> ();
  Eigen::Matrix3Xd points (3, 5);
  points << 0, 1, 0, 0, 1, //
    0, 0, 1, 0, 1,         //
    0, 0, 0, 1, 2;
  const auto status = pcl::manifold::makeSampleSet (points, {}, {}, 1e-16, *samples);
  const auto complex = pcl::manifold::computeDelaunayComplex (samples, 2);
  const bool sphere = meshesSphere ();
  std::cout << "delaunay answers " << pcl::manifold::toString (status) << ", " << complex->finite_cells
            << " tetrahedra over " << samples->size () << " points, a sphere is " << (sphere ? "" : "not ")
            << "one\n";
  return status == pcl::manifold::Status::OK && complex->finite_cells > 0 && sphere ? 0 : 1;
}
