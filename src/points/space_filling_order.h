#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl {
namespace manifold {

/** The permutation that sorts points along a Morton curve over their bounding box; ties, and so exact
 * duplicates, in lexicographic order of the coordinates and then by index. It depends on the coordinates
 * only, up to the order of exact duplicates. */
std::vector<std::int32_t> spaceFillingOrder (const Eigen::Matrix3Xd& points);

} // namespace manifold
} // namespace pcl
