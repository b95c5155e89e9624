#pragma once

#include <pcl/manifold/delaunay_complex.h>

#include "delaunay/circumcenter.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>

namespace pcl {
namespace manifold {

/** The Voronoi cell of one sample p, read from the flat arrays of the Delaunay complex. */
class VoronoiCell
{
public:
  VoronoiCell (const DelaunayComplex& complex, std::int32_t sample)
    : complex_ (complex), sample_ (sample), point_ (complex.samples->points.col (sample))
  {}

  std::int32_t sample () const { return sample_; }

  const std::int32_t* begin () const
  {
    return complex_.incident_cells.data () + complex_.incident_offsets[sample_];
  }

  const std::int32_t* end () const
  {
    return complex_.incident_cells.data () + complex_.incident_offsets[sample_ + 1];
  }

  bool isInfinite (std::int32_t vertex) const { return complex_.isInfinite (vertex); }

  /** A Voronoi vertex relative to p or, for an infinite one, its unit direction. */
  Eigen::Vector3d vertex (std::int32_t cell) const
  {
    if (complex_.isInfinite (cell))
      return complex_.centers.col (cell);
    return complex_.centers.col (cell) - point_;
  }

  /** The centre of a triangle at p relative to it, given as a facet of cell a. Where the samples lie in a
   * plane, the dual Voronoi edge is the line through it across the plane. */
  Eigen::Vector3d triangleCenter (std::int32_t a, int facet) const
  {
    // Not from relative corners: rounding could make them collinear.
    std::array<Eigen::Vector3d, 3> corners;
    for (int k = 0, count = 0; k < 4; ++k)
      if (k != facet)
        corners[count++] = complex_.samples->points.col (complex_.cells[a][k]);
    return circumcenter (corners[0], corners[1], corners[2]) - point_;
  }

  /** Another sample relative to p. */
  Eigen::Vector3d relative (std::int32_t sample) const
  {
    return complex_.samples->points.col (sample) - point_;
  }

  /** Calls visit (a, b, facet) once for every Delaunay facet at p that has no infinite vertex, that is for
   * every Voronoi edge of the cell: a < b are the cells on its two sides, of which b or, where the samples
   * lie in a plane, both may be infinite; vertex `facet` of a is the one opposite. */
  template <typename Visit>
  void forEachEdge (const Visit& visit) const
  {
    forEachFacet ([&] (std::int32_t a, std::int32_t b, int facet) {
      if (!complex_.isInfinite (a) || complex_.cells[a][facet] == DelaunayComplex::INFINITE_VERTEX)
        visit (a, b, facet);
    });
  }

  /** Calls visit (a, b, q, r) for every unbounded Voronoi face of the cell, dual to the hull edge from p to
   * q: a and b are the infinite cells on its two sides, r the third vertex of the hull facet of a. */
  template <typename Visit>
  void forEachUnboundedFace (const Visit& visit) const
  {
    forEachFacet ([&] (std::int32_t a, std::int32_t b, int facet) {
      if (!complex_.isInfinite (a) || complex_.cells[a][facet] == DelaunayComplex::INFINITE_VERTEX)
        return;
      for (const std::int32_t vertex : complex_.cells[a])
        if (vertex != sample_ && vertex != DelaunayComplex::INFINITE_VERTEX &&
            vertex != complex_.cells[a][facet])
          visit (a, b, vertex, complex_.cells[a][facet]);
    });
  }

  /** Calls visit (q) for every Delaunay neighbour q of p, seldom more than twice: from those cells at the
   * edge to q that have a smaller number than the two next to them around the edge. */
  template <typename Visit>
  void visitNeighbors (const Visit& visit) const
  {
    for (const std::int32_t cell : *this) {
      const DelaunayComplex::Cell& vertices = complex_.cells[cell];
      const DelaunayComplex::Cell& across = complex_.neighbors[cell];
      for (int k = 0; k < 4; ++k) {
        if (vertices[k] == sample_ || vertices[k] == DelaunayComplex::INFINITE_VERTEX)
          continue;
        bool first = true;
        for (int other = 0; other < 4; ++other)
          first = first && (other == k || vertices[other] == sample_ || cell <= across[other]);
        if (first)
          visit (vertices[k]);
      }
    }
  }

  /** Calls visit (q) for every Delaunay neighbour q of p, once for every cell at the edge to it. */
  template <typename Visit>
  void forEachNeighbor (const Visit& visit) const
  {
    for (const std::int32_t cell : *this)
      for (const std::int32_t vertex : complex_.cells[cell])
        if (vertex != sample_ && vertex != DelaunayComplex::INFINITE_VERTEX)
          visit (vertex);
  }

  /** Calls visit (a, b, facet) once for every facet at p, with or without infinite vertex: a < b are its
   * cells. */
  template <typename Visit>
  void forEachFacet (const Visit& visit) const
  {
    for (const std::int32_t cell : *this)
      for (int k = 0; k < 4; ++k)
        if (complex_.cells[cell][k] != sample_ && cell < complex_.neighbors[cell][k])
          visit (cell, complex_.neighbors[cell][k], k);
  }

private:
  const DelaunayComplex& complex_;
  std::int32_t sample_;
  Eigen::Vector3d point_;
};

} // namespace manifold
} // namespace pcl
