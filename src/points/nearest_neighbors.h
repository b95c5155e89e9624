#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl {
namespace manifold {

/** The k nearest neighbours of every point among the points, without itself, nearest first: row i is
 * [i * k, i * k + k). k must be smaller than the number of points. Parallel in the current arena. */
std::vector<std::int32_t> kNearestNeighbors (const Eigen::Matrix3Xd& points, int k);

/** For every query the index of the nearest point. */
std::vector<std::int32_t> nearestPoints (const Eigen::Matrix3Xd& points, const Eigen::Matrix3Xd& queries);

} // namespace manifold
} // namespace pcl
