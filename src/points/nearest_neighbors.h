#pragma once

#include <pcl/manifold/export.h>
#include <pcl/manifold/status.h>
#include <pcl/types.h>

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl {
namespace manifold {

/** The k nearest neighbours of every point among the points, without itself; of equally near ones those of
 * smaller index, squared distances being sums of doubles in the order of the axes. Row i, in ascending order,
 * is [i * k, i * k + k). k must be smaller than the number of points, and squared distances finite. The time
 * grows with the square of the number of exact duplicates. Parallel in the current arena.
 * \param[in] progress if there is one, asked now and then with the share that is done; where it answers false
 * there is no result */
PCL_MANIFOLD_CORE_EXPORTS std::vector<pcl::index_t> kNearestNeighbors (
  const Eigen::Ref<const Eigen::MatrixXd>& points, int k, const ProgressCallback& progress = {});

/** For every query the index of the nearest point, of several the smallest. */
PCL_MANIFOLD_CORE_EXPORTS std::vector<std::int32_t> nearestPoints (const Eigen::Matrix3Xd& points,
                                                                   const Eigen::Matrix3Xd& queries);

} // namespace manifold
} // namespace pcl
