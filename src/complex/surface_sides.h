#pragma once

#include "complex/vertex_numbering.h"

#include <pcl/manifold/topology_report.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace manifold {

/** \brief Which faces of a surface share which edges.
 *
 * A side is one edge seen from one of its faces; the sides of face f are starts[f] to starts[f + 1] - 1 and
 * go around it. Side s leaves the vertex origin[s] for the origin of the next side of its face. Faces and
 * vertices are numbered anew: degenerate faces (see SurfaceTopology) are left out, and so are vertices that
 * no other face uses. */
struct SurfaceSides
{
  using Index = std::uint32_t;

  static constexpr Index border = ~Index (0);           ///< twin of the side of an edge of one face
  static constexpr Index non_manifold = ~Index (0) - 1; ///< twin of a side of an edge of more than two faces

  std::vector<Index> starts;      ///< one more than there are faces
  std::vector<Index> origin;      ///< a side's first vertex
  std::vector<Index> face;        ///< a side's face
  std::vector<Index> twin;        ///< the other side of the same edge, or one of the two values above
  std::vector<Index> edge_starts; ///< where each edge starts in edge_sides, and their end
  std::vector<Index> edge_sides;  ///< sides edge by edge
  std::vector<Index> source;      ///< the face's number in the input
  std::size_t vertices = 0;
  std::size_t degenerate_faces = 0;

  /** \brief Sort out the sides of some faces; linear in their number, but for faces around one vertex n log
   * n.
   * \param[in] faces any rows
   * \param[in] index_end faces with an index from here on count as degenerate
   * \throw std::length_error for 2^32 - 2 sides or more */
  explicit SurfaceSides (const FaceRows& faces, std::size_t index_end = static_cast<std::size_t> (-1));

  std::size_t faces () const { return starts.size () - 1; }

  std::size_t edges () const { return edge_starts.size () - 1; }

  Index next (Index side) const
  {
    const Index f = face[side];
    return side + 1 == starts[f + 1] ? starts[f] : side + 1;
  }

  Index previous (Index side) const
  {
    const Index f = face[side];
    return (side == starts[f] ? starts[f + 1] : side) - 1;
  }

  /** \brief Does an edge of exactly two faces go on behind this side? */
  bool hasTwin (Index side) const { return twin[side] < non_manifold; }

private:
  void takeFaces (const FaceRows& faces, std::size_t index_end);

  void groupSides ();
};

/** \brief Triangles as rows. */
FaceRows toFaceRows (const std::vector<SimplicialComplex::Triangle>& triangles);

} // namespace manifold
} // namespace pcl
