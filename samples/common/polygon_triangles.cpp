#include "polygon_triangles.h"

namespace pcl::manifold::apps {

pcl::SimplicialComplex
trianglesOf (const pcl::PolygonMesh& mesh)
{
  pcl::SimplicialComplex complex;
  for (const pcl::Vertices& polygon : mesh.polygons)
    for (std::size_t i = 2; i < polygon.vertices.size (); ++i)
      complex.triangles.push_back ({polygon.vertices[0], polygon.vertices[i - 1], polygon.vertices[i]});
  return complex;
}

} // namespace pcl::manifold::apps
