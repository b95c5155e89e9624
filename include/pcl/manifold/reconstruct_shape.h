#pragma once

#include <pcl/manifold/detect_dimensions.h>
#include <pcl/manifold/export.h>
#include <pcl/manifold/simplicial_complex.h>

#include <memory>

namespace pcl {
namespace manifold {

/** \brief Parameters of CoconeShape.
 * \ingroup manifold */
struct ShapeParameters
{
  DimensionParameters dimension; ///< of the first stages
  bool watertight = false;       ///< close every surface
};

/** \brief CoconeShape without PCL: from coordinates to a complex over the points of the cloud.
 * \param[in] points, indices, resolution as for detectDimensions
 * \param[in] parameters as the setters of CoconeShape explain them
 * \param[in,out] log of the stages
 * \param[out] dimensions what was found on the way, or handed in; null unless the answer is Status::OK
 * \param[out] shape indices are those of the user's cloud; empty unless the answer is Status::OK
 * \return as detectDimensions, DIMENSION_TOO_LOW where all points are equal. Does not throw
 * \ingroup manifold */
PCL_MANIFOLD_DELAUNAY_EXPORTS Status reconstructShape (const Eigen::Matrix3Xd& points,
                                                       const pcl::Indices& indices, double resolution,
                                                       const ShapeParameters& parameters, StageLog& log,
                                                       std::shared_ptr<const SampleDimensions>& dimensions,
                                                       SimplicialComplex& shape) noexcept;

/** \brief The candidate simplices of COCONESHAPE as published, before any manifold extraction: see
 * CoconeShape::getCandidates. Throws where memory runs out.
 * \param[in] dimensions what was found at each sample
 * \return edges, triangles and tetrahedra; indices are those of the user's cloud
 * \ingroup manifold */
PCL_MANIFOLD_DELAUNAY_EXPORTS SimplicialComplex candidateShape (const SampleDimensions& dimensions);

} // namespace manifold
} // namespace pcl
