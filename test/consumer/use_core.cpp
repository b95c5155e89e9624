/** \file
 * A user's program that links pcl_manifold::core alone. */
#include <pcl/manifold/simplicial_complex.h>
#include <pcl/manifold/status.h>

#include <iostream>

int
main ()
{
  pcl::SimplicialComplex complex;
  complex.tetrahedra.push_back ({0, 1, 2, 3});
  const auto skin = pcl::manifold::boundaryTriangles (complex.tetrahedra);
  std::cout << "core answers " << pcl::manifold::toString (pcl::manifold::Status::OK)
            << ", a tetrahedron has " << skin.size () << " sides\n";
  return skin.size () == 4 ? 0 : 1;
}
