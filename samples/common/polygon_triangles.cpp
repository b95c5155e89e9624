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

FaceRows
facesOf (const pcl::PolygonMesh& mesh)
{
  FaceRows rows;
  for (const pcl::Vertices& polygon : mesh.polygons) {
    rows.vertices.insert (rows.vertices.end (), polygon.vertices.begin (), polygon.vertices.end ());
    rows.starts.push_back (rows.vertices.size ());
  }
  return rows;
}

} // namespace pcl::manifold::apps
