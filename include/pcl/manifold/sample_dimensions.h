#pragma once

#include <pcl/manifold/delaunay_complex.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace pcl {
namespace manifold {

/** \brief What DIMENSION (section 4 of Dey, Giesen, Goswami and Zhao) finds at each sample, and what is
 * decided from it and the labels of the neighbours.
 * \ingroup manifold */
struct SampleDimensions
{
  std::shared_ptr<const DelaunayComplex> complex; ///< of the samples

  /// As published: 1 at samples of a curve and at the rim of a surface, 2 at samples of a surface and at the
  /// skin of a solid, 3 inside of a solid. Never more than the affine dimension of the samples.
  std::vector<std::uint8_t> dimension;
  /// The dimension of the manifold that the sample belongs to.
  std::vector<std::uint8_t> manifold_dimension;
  /// Whether the sample is on the boundary of that manifold.
  std::vector<std::uint8_t> boundary;
  /// Samples that were taken for ones of a curve although others lie beside it: the points of a surface lie
  /// in rows, or they are noisy.
  std::size_t contradicted = 0;
  /// How far the ratios of the heights are from rho, in [0, 1]: 0 = on the edge between two answers.
  std::vector<float> confidence;

  /// H1, H2, H3 of Definition 2.3 in the unit of the samples; infinite where a Voronoi subpolytope is
  /// unbounded.
  Eigen::Matrix3Xd heights;
  /// Unit vectors along the poles of V3: the normal of a surface.
  Eigen::Matrix3Xd normals;
  /// Unit vectors along the poles of V1: the tangent of a curve.
  Eigen::Matrix3Xd tangents;
};

} // namespace manifold
} // namespace pcl
