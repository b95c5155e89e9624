#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstdint>
#include <vector>

namespace pcl {
namespace manifold {

/** The permutation that sorts points along a Morton curve over a box; points outside of it count as the
 * nearest ones in it, and ties, exact duplicates among them, are in lexicographic order of the coordinates
 * and then by index. It depends on the coordinates only, up to the order of exact duplicates. */
std::vector<std::int32_t> spaceFillingOrder (const Eigen::Matrix3Xd& points, const Eigen::AlignedBox3d& box);

} // namespace manifold
} // namespace pcl
