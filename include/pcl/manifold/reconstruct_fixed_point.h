#pragma once

#include <pcl/manifold/fixed_point_complex.h>
#include <pcl/manifold/simplicial_complex.h>

#include <memory>

namespace pcl {
namespace manifold {

/** \brief Parameters of FixedPointReconstruction.
 * \ingroup manifold */
struct FixedPointParameters
{
  Thinning thinning;                              ///< none by default
  CriticalPointParameters critical;               ///< the published ones by default
  bool watertight = false;                        ///< close every surface
  unsigned int threads = 0;                       ///< 0 = all cores
  std::shared_ptr<const DelaunayComplex> complex; ///< of the same points and thinning, or null

  /// Where the restricted Delaunay operator starts, in the coordinates of the cloud; null for the manifold
  /// fixed-point complex.
  std::shared_ptr<const FlatPieces> initial_mesh;
};

/** \brief What FixedPointReconstruction found on the way.
 * \ingroup manifold */
struct FixedPointResult
{
  std::shared_ptr<const DelaunayComplex> complex; ///< of the samples

  /// The manifold fixed-point complex or, with an initial mesh, the fixed point that it leads to in `facets`,
  /// and nothing else.
  FixedPointComplex found;

  int iterations = 0; ///< with an initial mesh: how often the operator was applied
};

/** \brief FixedPointReconstruction without PCL: from coordinates to a surface over the points of the cloud.
 * \param[in] points, indices, resolution as for detectDimensions
 * \param[in] parameters as the setters of FixedPointReconstruction explain them
 * \param[in,out] log of the stages
 * \param[out] result what was found on the way; without complex unless the answer is Status::OK
 * \param[out] shape triangles over the user's cloud; empty unless the answer is Status::OK
 * \return as detectDimensions, TOO_FEW_POINTS for fewer than three distinct points, DIMENSION_TOO_LOW where no
 * surface was found. Does not throw
 * \ingroup manifold */
PCL_MANIFOLD_DELAUNAY_EXPORTS Status reconstructFixedPoint (const Eigen::Matrix3Xd& points,
                                                            const pcl::Indices& indices, double resolution,
                                                            const FixedPointParameters& parameters,
                                                            StageLog& log, FixedPointResult& result,
                                                            SimplicialComplex& shape) noexcept;

/** \brief A set of Delaunay triangles over the points of the user's cloud.
 * \param[in] complex the triangulation
 * \param[in] facets which of its triangles
 * \return the triangles, not oriented, as indices into the cloud. Throws where memory runs out
 * \ingroup manifold */
PCL_MANIFOLD_DELAUNAY_EXPORTS SimplicialComplex facetShape (const DelaunayComplex& complex,
                                                            const FacetFlags& facets);

} // namespace manifold
} // namespace pcl
