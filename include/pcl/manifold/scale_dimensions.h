#pragma once

#include <pcl/manifold/detect_dimensions.h>
#include <pcl/manifold/export.h>
#include <pcl/manifold/sample_dimensions.h>
#include <pcl/manifold/sample_set.h>
#include <pcl/manifold/stage_log.h>
#include <pcl/manifold/status.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace pcl {
namespace manifold {

/** \brief At which scales the dimension is asked for, see DimensionDetection::setScales.
 * \ingroup manifold */
struct ScaleParameters
{
  double from = 0.0; ///< the finest spacing, in the unit of the cloud; 0 = that of the points
  double to = 0.0;   ///< the coarsest one; 0 = an eighth of the extent
  /// Where the sensor stood, in the coordinates of the cloud.
  std::optional<Eigen::Vector3d> sensor_origin;
};

/** \brief A curve that points lie on: a wire, a pole, a branch.
 * \ingroup manifold */
struct CurveMeasures
{
  std::size_t points = 0;                                ///< of the cloud
  Eigen::Vector3d direction = Eigen::Vector3d::UnitX (); ///< unit vector along which its points spread most
  double length = 0.0;                                   ///< extent along that, in the unit of the cloud
  double height = 0.0;                                   ///< extent along z, in the unit of the cloud
  double verticality = 0.0;                              ///< the cosine of the angle between direction and z
  double mean_radius = 0.0;                              ///< mean distance of its points from its axis
};

/** \brief The dimension that persists over the scales, per sample.
 * \ingroup manifold */
struct ScaleDimensions
{
  std::shared_ptr<const SampleSet> samples; ///< the distinct points, thinned if that was asked for

  std::vector<std::uint8_t> dimension;          ///< as published, of the level from which on the answer holds
  std::vector<std::uint8_t> manifold_dimension; ///< the label that persists: 1, 2, 3
  std::vector<std::uint8_t> boundary;           ///< 1 on the rim, skin or end of the manifold, at that level
  std::vector<float> confidence;     ///< mean over the levels on which the label persists, in [0, 1]
  std::vector<float> scale;          ///< spacing from which on it does, in the unit of the cloud
  std::vector<float> persistence;    ///< octaves over which it does
  Eigen::Matrix3Xf tangents;         ///< unit vectors along curves; 0 elsewhere
  std::vector<std::int32_t> curve;   ///< index into curves, or -1
  std::vector<CurveMeasures> curves; ///< numbered by their first samples

  /// Whether the sensor's place was known or recognised.
  std::optional<Eigen::Vector3d> sensor_origin;
  /// The published answer at the finest level; null where the sensor's place is known: it is found in
  /// coordinates of the sensor then.
  std::shared_ptr<const SampleDimensions> finest;
};

/** \brief DimensionDetection over all scales, without PCL.
 * \param[in] points coordinates of the points that the indices name, 3 x n
 * \param[in] indices of the points in the user's cloud, or empty for 0 .. n-1
 * \param[in] resolution relative precision of the coordinates, FLOAT_RESOLUTION for floats
 * \param[in] parameters as the setters of DimensionDetection explain them
 * \param[in] scales likewise
 * \param[in,out] log of the stages
 * \param[out] result null unless the answer is Status::OK
 * \return as detectDimensions; PARAMETER_OUT_OF_RANGE also for scales that are negative, not finite or upside down,
 * and for an origin that is not finite. Does not throw
 * \ingroup manifold */
PCL_MANIFOLD_DELAUNAY_EXPORTS Status detectScales (const Eigen::Matrix3Xd& points,
                                                   const pcl::Indices& indices, double resolution,
                                                   const DimensionParameters& parameters,
                                                   const ScaleParameters& scales, StageLog& log,
                                                   std::shared_ptr<const ScaleDimensions>& result) noexcept;

} // namespace manifold
} // namespace pcl
