#pragma once

#include <pcl/manifold/export.h>
#include <pcl/manifold/status.h>
#include <pcl/types.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace manifold {

/** \brief The relative precision of the coordinates of a cloud of floats.
 * \ingroup manifold */
constexpr double FLOAT_RESOLUTION = 5.9604644775390625e-08; // 2^-24

/** \brief How a cloud is thinned to a sample that meets the (eps, delta) condition of Definition 2.1 of Dey,
 * Giesen, Goswami and Zhao.
 * \ingroup manifold */
struct Thinning
{
  int neighbors = 0;     ///< no two samples are among each other's k nearest neighbours; 0 = off
  double distance = 0.0; ///< no two samples are nearer than this, in the unit of the cloud; 0 = off
};

/** \brief The distinct finite points of a cloud that a reconstruction works on, in an order that depends on
 * their coordinates only (along a space-filling curve), so that nothing computed from it depends on the order
 * of the input.
 *
 * Left out as well are rays that met nothing where these are stored as points: two or more points at exactly
 * (0, 0, 0) where no others coincide, or more than four times as many as at any other place, farther from all
 * others but seven than five times the median distance of a point to its nearest one; or, of a cloud that was
 * moved, 16 and more points at one place, more than 16 times as many as at any other, and farther from all
 * others but seven than 16 of these distances. One point at (0, 0, 0) is a point, and so is the pole of a
 * lathe, which is near to the ring beside it.
 * \ingroup manifold */
struct SampleSet
{
  /// Sample coordinates: (input - origin) * scale, which is exact for floats, and for doubles in the bulk of
  /// the cloud; strays may be rounded. The origin is in the middle of the bulk where that is far from zero.
  /// Scale is a power of two that makes the largest extent lie in [1, 2).
  Eigen::Matrix3Xd points;
  Eigen::Vector3d origin = Eigen::Vector3d::Zero (); ///< in the coordinates of the input
  double scale = 1.0;                                ///< a power of two

  /// Per sample the index of its point in the user's cloud: the first of its exact duplicates.
  pcl::Indices input_index;

  /// Per entry of the user's indices its own sample or, where that was thinned out, the nearest one; -1 for
  /// points that are not finite or no measurement.
  std::vector<std::int32_t> sample_of;

  std::size_t non_finite = 0;     ///< input points dropped because a coordinate is NaN or infinite
  std::size_t no_measurement = 0; ///< input points dropped because they stand for no measurement
  std::size_t duplicates = 0;     ///< input points merged with an equal one
  std::size_t thinned = 0;        ///< distinct points left out by thinning

  /** \brief The number of samples.
   * \return the columns of points */
  std::int32_t size () const { return static_cast<std::int32_t> (points.cols ()); }
};

/** \brief Makes the sample set of a cloud.
 * \param[in] points the coordinates of the points that the user's indices name, 3 x n
 * \param[in] indices the user's indices, n, or empty for 0 .. n-1
 * \param[in] thinning what to leave out
 * \param[in] resolution the relative precision of the input's coordinates (2^-24 for float)
 * \param[out] samples the result; empty unless the answer is Status::OK
 * \return NO_INPUT where no point is finite, PARAMETER_OUT_OF_RANGE for a negative or non-finite thinning,
 * INPUT_TOO_COARSE where most points are no more than a few steps of the coordinates' type, there, from their
 * nearest ones, INPUT_OUT_OF_RANGE where the extent of the points overflows, TOO_MANY_POINTS for more than
 * 2^31
 * - 1
 *
 * O (n log n), plus one k-nearest-neighbour search of every point where thinning asks for it.
 * \ingroup manifold */
PCL_MANIFOLD_CORE_EXPORTS Status makeSampleSet (const Eigen::Ref<const Eigen::Matrix3Xd>& points,
                                                const pcl::Indices& indices, const Thinning& thinning,
                                                double resolution, SampleSet& samples);

} // namespace manifold
} // namespace pcl
