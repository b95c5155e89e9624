#pragma once

#include <pcl/manifold/export.h>

#include <Eigen/Core>

#include <vector>

namespace pcl {
namespace manifold {

/** The distance of a point to its nearest other one. */
struct NearestDistance
{
  Eigen::Index point;
  double distance;
};

/** These distances, for at most a thousand of the points, spread evenly over their order; for none if there
 * is but one point. */
std::vector<NearestDistance> nearestDistances (const Eigen::Matrix3Xd& points);

/** Their median; infinity if there is none. */
PCL_MANIFOLD_CORE_EXPORTS double medianSpacing (const Eigen::Matrix3Xd& points);

} // namespace manifold
} // namespace pcl
