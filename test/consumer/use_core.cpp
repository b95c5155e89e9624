/** \file
 * A user's program that links pcl_manifold::core alone. */
#include <pcl/manifold/graph_reconstruction.h>
#include <pcl/manifold/simplicial_complex.h>
#include <pcl/manifold/status.h>

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

/** The genus of what is reconstructed from the points of a sphere; -1 on failure. */
template <typename PointT>
double
genusOfSphere ()
{
  constexpr int POINTS = 5000;
  typename pcl::PointCloud<PointT>::Ptr cloud (new pcl::PointCloud<PointT>);
  for (int i = 0; i < POINTS; ++i) {
    const double z = 1.0 - (2.0 * i + 1.0) / POINTS;
    const double radius = std::sqrt (1.0 - z * z);
    PointT point;
    point.x = static_cast<float> (radius * std::cos (2.399963 * i));
    point.y = static_cast<float> (radius * std::sin (2.399963 * i));
    point.z = static_cast<float> (z);
    cloud->push_back (point);
  }
  pcl::GraphReconstruction<PointT> reconstruction;
  reconstruction.setInputCloud (cloud);
  pcl::PolygonMesh mesh;
  reconstruction.reconstruct (mesh);
  if (reconstruction.getStatus () != pcl::manifold::Status::OK || mesh.polygons.empty ())
    return -1.0;
  return reconstruction.getReport ().surface.components.front ().genus;
}

} // namespace

int
main ()
{
  pcl::SimplicialComplex complex;
  complex.tetrahedra.push_back ({0, 1, 2, 3});
  const auto skin = pcl::manifold::boundaryTriangles (complex.tetrahedra);
  const double genus = genusOfSphere<pcl::PointXYZ> ();
  const double genus_of_own = genusOfSphere<SonarPoint> ();
  std::cout << "core answers " << pcl::manifold::toString (pcl::manifold::Status::OK)
            << ", a tetrahedron has " << skin.size () << " sides, a sphere has genus " << genus << " and "
            << genus_of_own << "\n";
  return skin.size () == 4 && genus == 0.0 && genus_of_own == 0.0 ? 0 : 1;
}
