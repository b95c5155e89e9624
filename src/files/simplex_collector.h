#pragma once

#include <pcl/manifold/simplicial_complex.h>

#include <cstddef>

namespace pcl::manifold {

/** \brief Takes the polygons and polylines of a file into a complex, without those that repeat a
 * vertex. The indices must have been checked. */
class SimplexCollector
{
public:
  explicit SimplexCollector (SimplicialComplex& complex) : complex_ (complex) {}

  void addEdge (pcl::index_t a, pcl::index_t b)
  {
    if (a != b)
      complex_.edges.push_back ({a, b});
  }

  void addPolyline (const pcl::index_t* vertices, std::size_t size)
  {
    for (std::size_t i = 1; i < size; ++i)
      addEdge (vertices[i - 1], vertices[i]);
  }

  void addTriangle (pcl::index_t a, pcl::index_t b, pcl::index_t c)
  {
    if (a != b && b != c && c != a)
      complex_.triangles.push_back ({a, b, c});
  }

  /** \brief A fan of triangles from the first vertex; two vertices are an edge, fewer nothing. */
  void addPolygon (const pcl::index_t* vertices, std::size_t size)
  {
    if (size == 2)
      addEdge (vertices[0], vertices[1]);
    for (std::size_t i = 2; i < size; ++i)
      addTriangle (vertices[0], vertices[i - 1], vertices[i]);
  }

private:
  SimplicialComplex& complex_;
};

} // namespace pcl::manifold
