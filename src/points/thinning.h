#pragma once

#include <pcl/manifold/export.h>

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl {
namespace manifold {

/** Greedy subsets that respect a distance between the samples, chosen in a seeded random order of the points
 * so that no pattern of the scan carries over. Both return a flag per point: 1 = kept.
 *
 * thinByNeighbors: no kept point is among the k nearest neighbours of another kept one. */
std::vector<std::uint8_t> thinByNeighbors (const Eigen::Matrix3Xd& points, int k);

/** thinBySpacing: no two kept points are nearer than the spacing, and every point has a kept one nearer than
 * that or is kept itself. */
PCL_MANIFOLD_CORE_EXPORTS std::vector<std::uint8_t> thinBySpacing (const Eigen::Matrix3Xd& points,
                                                                   double spacing);

} // namespace manifold
} // namespace pcl
