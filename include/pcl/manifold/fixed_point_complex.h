#pragma once

#include <pcl/manifold/delaunay_complex.h>
#include <pcl/manifold/export.h>
#include <pcl/manifold/stage_log.h>
#include <pcl/manifold/status.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace manifold {

/** \brief A set of Delaunay triangles as a flag for every facet of every cell: both facets of a triangle have
 * the same flag.
 * \ingroup manifold */
struct FacetFlags
{
  std::vector<std::uint8_t> mask; ///< a byte a cell; bit k is the facet opposite of vertex k

  /** \brief Whether the triangle that is a facet of a cell is in the set; it may be asked of either cell.
   * \param[in] cell its number
   * \param[in] facet the number of the vertex opposite of it in the cell, 0 to 3
   * \return true if so */
  bool contains (std::int32_t cell, int facet) const { return (mask[cell] >> facet & 1) != 0; }
};

inline bool
operator== (const FacetFlags& a, const FacetFlags& b)
{
  return a.mask == b.mask;
}

inline bool
operator!= (const FacetFlags& a, const FacetFlags& b)
{
  return !(a == b);
}

/** \brief A mesh in the coordinates of the samples (SampleSet::points). Its triangles need not fit together,
 * and may be as flat as a segment or a point.
 * \ingroup manifold */
struct FlatPieces
{
  Eigen::Matrix3Xd vertices;                          ///< a column each
  std::vector<std::array<std::int32_t, 3>> triangles; ///< columns of vertices
};

/** \brief The restricted Delaunay triangulation of the samples by a mesh, Del|Lambda V of Khoury and
 * Shewchuk: the Delaunay triangles whose dual Voronoi edges meet a triangle of the mesh.
 *
 * It is exact for the coordinates as they are. Mesh triangles and Voronoi edges are closed sets: where they
 * touch they meet, and nothing is perturbed. Where samples are cospherical, so that Voronoi edges have length
 * zero, all Delaunay triangles whose dual Voronoi edges have the centre of the sphere in them are met
 * together; which triangles there are is up to the triangulation.
 * \param[in] complex of any affine dimension; below 2 it has no triangles, and the result is empty
 * \param[in] pieces the mesh
 * \param[out] result as many flags as there are cells; empty unless the answer is Status::OK
 * \return PARAMETER_OUT_OF_RANGE where a coordinate is not finite or a triangle names no vertex
 *
 * Parallel over the triangles in the current arena; the time is that of finding the sample nearest to each
 * and in proportion to the Voronoi faces that it meets. Does not throw.
 * \ingroup manifold */
PCL_MANIFOLD_DELAUNAY_EXPORTS Status restrictedDelaunay (const DelaunayComplex& complex,
                                                         const FlatPieces& pieces,
                                                         FacetFlags& result) noexcept;

/** \brief As above for a set of Delaunay triangles as the mesh. A triangle of the set whose own dual Voronoi
 * edge it meets is in the result, too: it is anchored.
 * \param[in] complex of any affine dimension
 * \param[in] pieces one byte a cell of the complex
 * \return as many flags as there are cells
 *
 * Throws where memory runs out.
 * \ingroup manifold */
PCL_MANIFOLD_DELAUNAY_EXPORTS FacetFlags restrictedDelaunay (const DelaunayComplex& complex,
                                                             const FacetFlags& pieces);

/** \brief Where the restricted Delaunay operator leads to.
 * \ingroup manifold */
struct FixedPoint
{
  FacetFlags facets;  ///< the operator maps this to itself
  int iterations = 0; ///< how often the operator was applied to get there
};

/** \brief Applies the restricted Delaunay operator to a set of Delaunay triangles until nothing changes,
 * which is always the case in the end. By Theorem 2 the fixed point has every anchored triangle that descends
 * from the start, and every triangle that descends from these; the triangles that each one generates are
 * computed once. Parallel in the current arena. Throws where memory runs out.
 * \param[in] complex of any affine dimension
 * \param[in] start one byte a cell of the complex
 * \return the fixed point, and how many steps led to it
 * \ingroup manifold */
PCL_MANIFOLD_DELAUNAY_EXPORTS FixedPoint fixedPoint (const DelaunayComplex& complex, const FacetFlags& start);

/** \brief How critical points near the surface are told from those near its medial axis.
 * \ingroup manifold */
struct CriticalPointParameters
{
  /// A sample v of an anchored triangle with the circumcentre z calls it medial if |vz| / |vp| is more than
  /// this, p being the pole of v that is nearest to the direction of z, or the negative pole of an unbounded
  /// Voronoi cell. Positive; 0.313 is what the guarantee for 0.143-samples needs.
  double ratio = 0.313;
  /// How many of the three samples must do so for the triangle to be medial: 1 to 3. In the theory all agree.
  int votes = 1;
};

/** \brief The manifold fixed-point complex of Khoury and Shewchuk, section 8.
 * \ingroup manifold */
struct FixedPointComplex
{
  FacetFlags facets;        ///< of the whole complex: manifold anchored and chained triangles
  FacetFlags manifold;      ///< the anchored triangles near the surface
  FacetFlags medial;        ///< those near its medial axis; can be in the complex, as chained triangles
  std::size_t anchored = 0; ///< number of all anchored triangles: those that meet their dual Voronoi edges
  std::size_t medial_anchored = 0; ///< how many of these are medial
  std::size_t chained = 0;         ///< triangles of the complex that are not manifold anchored
};

/** \brief Computes the manifold fixed-point complex: the union of all fixed points of the restricted Delaunay
 * operator that stay away from the medial axis.
 * \param[in] complex of any affine dimension; below 2 the result has no triangles
 * \param[in] parameters of the classification
 * \param[in,out] log told of the stages
 * \param[out] result empty unless the answer is Status::OK
 * \return PARAMETER_OUT_OF_RANGE for a ratio that is not positive or for votes other than 1 to 3, CANCELLED
 * where the log says so
 *
 * What is anchored and what is chained is decided exactly; the classification compares distances in doubles.
 * Parallel in the current arena. Does not throw.
 * \ingroup manifold */
PCL_MANIFOLD_DELAUNAY_EXPORTS Status computeFixedPointComplex (const DelaunayComplex& complex,
                                                               const CriticalPointParameters& parameters,
                                                               StageLog& log,
                                                               FixedPointComplex& result) noexcept;

} // namespace manifold
} // namespace pcl
