#pragma once

#include <pcl/manifold/sample_dimensions.h>

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl {
namespace manifold {

/** What a level of the ladder says of each of its samples. */
struct LevelEvidence
{
  double spacing = 0.0; ///< as of the level
  /// Of the published method and of what is decided from it, see SampleDimensions.
  std::vector<std::uint8_t> dimension, manifold_dimension, boundary;
  std::vector<float> confidence;
  std::vector<std::uint8_t> flat; ///< whether the samples around it lie near a plane
  /// Unit vectors along which the samples around each spread most.
  Eigen::Matrix3Xf direction;
  /// The length of the piece of a curve that the sample belongs to, in spacings; 0 where there is none.
  std::vector<float> length;
  std::vector<std::int32_t> piece; ///< the number of that piece, or -1
  std::int32_t pieces = 0;
};

/** Looks at the samples of a level, beyond the published labels, for what those cannot tell: a rim has the
 * label of a curve, and so has a scan line.
 *
 * Around a sample of a curve the others within two and a half spacings, at most two on either side, lie along
 * a line. Such samples, and those labelled so by most of their neighbours, are sure; they are joined with
 * doubtful ones along their directions into pieces, and a piece counts where half of it is sure and it is
 * three spacings long.
 * \param[in] dimensions of the samples of the level
 * \param[in] sample_of per centre of the level its sample there
 * \param[in] spacing in the unit of the samples' own coordinates
 * \return per centre; spacing is left to the caller */
LevelEvidence evaluateLevel (const SampleDimensions& dimensions, const std::vector<std::int32_t>& sample_of,
                             double spacing);

} // namespace manifold
} // namespace pcl
