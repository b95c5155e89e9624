#pragma once

#include <pcl/PCLPointCloud2.h>
#include <pcl/PolygonMesh.h>
#include <pcl/manifold/export.h>
#include <pcl/types.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace pcl {

/** \brief A simplicial complex over the points of a cloud, given by its maximal simplices: the edges that are
 * no side of a triangle, the triangles that are no side of a tetrahedron, and the tetrahedra. Indices are
 * those of the cloud that it was reconstructed from.
 * \ingroup manifold */
struct SimplicialComplex
{
  /// Two vertices.
  using Edge = std::array<pcl::index_t, 2>;
  /// Three vertices.
  using Triangle = std::array<pcl::index_t, 3>;
  /// Four vertices.
  using Tetrahedron = std::array<pcl::index_t, 4>;

  std::vector<Edge> edges;             ///< in no direction
  std::vector<Triangle> triangles;     ///< oriented as neighbours are, where that is possible
  std::vector<Tetrahedron> tetrahedra; ///< positively oriented: det (b - a, c - a, d - a) > 0

  /** \brief Whether there is no simplex.
   * \return true if so */
  bool empty () const { return edges.empty () && triangles.empty () && tetrahedra.empty (); }

  /** \brief Removes all simplices. */
  void clear ()
  {
    edges.clear ();
    triangles.clear ();
    tetrahedra.clear ();
  }
};

namespace manifold {

/** \brief Are all simplices over existing and pairwise distinct vertices?
 * \param[in] complex the complex to look at
 * \param[in] vertices the number of points of its cloud: valid indices are 0 to \a vertices - 1
 * \param[out] why if given and the answer is no, one line about the first wrong simplex
 * \return true for a valid complex, the empty one among them
 * \ingroup manifold */
PCL_MANIFOLD_CORE_EXPORTS bool isValid (const SimplicialComplex& complex, std::size_t vertices,
                                        std::string* why = nullptr);

/** \brief The boundary of a set of tetrahedra: the triangles that belong to exactly one of them.
 *
 * The triangles of positively oriented tetrahedra come out facing outward (counter-clockwise seen from
 * outside); they are in the order of their tetrahedra. Linear in the number of tetrahedra. Tetrahedra with a
 * repeated or negative vertex are passed over.
 * \param[in] tetrahedra positively oriented, det (b - a, c - a, d - a) > 0
 * \return the triangles, every one once
 * \ingroup manifold */
PCL_MANIFOLD_CORE_EXPORTS std::vector<SimplicialComplex::Triangle> boundaryTriangles (
  const std::vector<SimplicialComplex::Tetrahedron>& tetrahedra);

/** \brief What orientTriangles () found. A patch is a set of triangles that hang together through edges of
 * exactly two triangles.
 * \ingroup manifold */
struct Orientation
{
  std::size_t patches = 0;                ///< sets of triangles that hang together
  std::size_t non_orientable_patches = 0; ///< patches such as a Moebius band, left with a cut across them
};

/** \brief Turn triangles so that neighbours agree wherever that is possible.
 *
 * Works patch by patch, a patch being what hangs together through edges of exactly two triangles. The first
 * triangle of a patch keeps its direction and its neighbours follow. In a patch that is not orientable some
 * pairs of neighbours cannot agree; which ones depends on the order of the triangles only. Linear in the
 * number of triangles. Triangles with a repeated or negative vertex are left alone.
 * \param[in,out] triangles their order and their sets of vertices stay as they are
 * \return the numbers of patches
 * \ingroup manifold */
PCL_MANIFOLD_CORE_EXPORTS Orientation orientTriangles (std::vector<SimplicialComplex::Triangle>& triangles);

/** \brief As orientTriangles (triangles), then every orientable patch without boundary is turned outward:
 * it encloses a positive volume. A patch with a boundary is turned away from its middle if it is bent around
 * that; if not, as a flat one, it keeps the direction of its first triangle. The wall of a cavity is turned
 * away from the cavity, as every other closed surface is away from its inside.
 * \param[in,out] triangles their order and their sets of vertices stay as they are
 * \param[in] points coordinates, one column a vertex; triangles that point beyond the last are left alone
 * \return the numbers of patches
 * \ingroup manifold */
PCL_MANIFOLD_CORE_EXPORTS Orientation orientTriangles (std::vector<SimplicialComplex::Triangle>& triangles,
                                                       const Eigen::Ref<const Eigen::Matrix3Xd>& points);

/** \brief A complex as a pcl::PolygonMesh: edges as polygons of two vertices, then the triangles, then the
 * boundary of the tetrahedra, because PCL's tools take a polygon of four vertices for a quadrangle.
 * \param[in] complex indices must be valid for \a cloud
 * \param[in] cloud the points, copied with all their fields
 * \param[out] mesh replaced; empty on failure
 * \return false, with a message through PCL_ERROR, when an index is not one of the cloud's points
 * \ingroup manifold */
PCL_MANIFOLD_CORE_EXPORTS bool toPolygonMesh (const SimplicialComplex& complex,
                                              const pcl::PCLPointCloud2& cloud, pcl::PolygonMesh& mesh);

} // namespace manifold
} // namespace pcl
