#pragma once

#include <pcl/manifold/export.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace pcl {
namespace manifold {

/** \brief The bounding box of the bulk of some points: that of all finite ones, cut off where it reaches
 * farther than a few times what half of the distinct points extend over. Strays, be they ever so far, and
 * values that stand for no measurement do not enlarge it, as long as they are fewer than a quarter of the
 * distinct points on either side; where nothing is so far away it is the bounding box itself.
 * \param[in] points any; what is not finite does not count
 * \return an empty box if no point is finite. It depends on the set of the points only, not on their order
 *
 * O (n): half of the points are found in a few thousand, chosen by their coordinates.
 * \ingroup manifold */
PCL_MANIFOLD_CORE_EXPORTS Eigen::AlignedBox3d bulkBox (const Eigen::Ref<const Eigen::Matrix3Xd>& points);

} // namespace manifold
} // namespace pcl
