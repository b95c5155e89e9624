#pragma once

#include <pcl/types.h>

#include <Eigen/Core>

#include <vector>

namespace pcl {
namespace manifold {

/** Coordinates of a sensor: along every ray the logarithm of the range takes the place of the range. That is
 * a diffeomorphism, so dimensions stay; and the spacing of what a turning sensor sees becomes about the same
 * near and far. With m the median range, a point at range r is moved to 2 + log (r / m), and to e r / m where
 * it is nearer than m / e, so that the unit of the cloud does not matter and the origin stays where it is. */
class SensorCoordinates
{
public:
  SensorCoordinates (const Eigen::Matrix3Xd& points, const Eigen::Vector3d& origin);

  const Eigen::Vector3d& origin () const { return origin_; }

  Eigen::Matrix3Xd toSensor (const Eigen::Matrix3Xd& points) const;

  /** The length in space at a point of what is short there: of one across the ray. */
  double widthAt (const Eigen::Vector3d& point) const;

  /** The direction in space at a point of a direction in coordinates of the sensor. */
  Eigen::Vector3d toSpace (const Eigen::Vector3d& point, const Eigen::Vector3d& direction) const;

private:
  Eigen::Vector3d origin_;
  double near_ = 0.0; ///< the range at which the logarithm begins; 0 where all points are at the origin
};

/** Whether points are a frame of a spinning lidar at an origin, with its axis along z: where the neighbours
 * of points lie along lines, these lines run around the axis. True for frames of 16 to 64 rings, where a
 * fifth of the points or more see only their own ring and nearly all of these lines are level.
 * \param[in] points distinct; 3000 of them, spread over their order, are asked
 * \param[in] neighbors NEAREST a point */
bool hasRings (const Eigen::Matrix3Xd& points, const std::vector<pcl::index_t>& neighbors,
               const Eigen::Vector3d& origin);

} // namespace manifold
} // namespace pcl
