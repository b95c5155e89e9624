/** \file
 * A user's program that links pcl_manifold::delaunay. It compiles without CGAL. */
#include <pcl/manifold/delaunay_complex.h>

#include <iostream>

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
  std::cout << "delaunay answers " << pcl::manifold::toString (status) << ", " << complex->finite_cells
            << " tetrahedra over " << samples->size () << " points\n";
  return status == pcl::manifold::Status::OK && complex->finite_cells > 0 ? 0 : 1;
}
