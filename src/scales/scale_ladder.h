#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl {
namespace manifold {

/** The spacings at which a cloud is looked at, in the unit of the points. */
struct ScaleRange
{
  double from = 0.0; ///< the points themselves and, above, what is no finer; 0 = from the typical spacing on
  double to = 0.0;   ///< none is coarser; 0 = an eighth of the largest extent
};

/** One level of the ladder: the points as they look at a spacing. */
struct ScaleLevel
{
  double spacing = 0.0;     ///< no two samples were kept that are nearer than this
  Eigen::Matrix3Xd centers; ///< per sample the mean of all points that it stands for, which averages noise
  /// Per sample of the level below its sample here. Empty at the first level, whose samples are the points.
  std::vector<std::int32_t> sample_of;
};

/** The median distance of the points to their nearest neighbours; 0 for fewer than two points. */
double typicalSpacing (const Eigen::Matrix3Xd& points);

/** The ladder of scales: its first level holds the points as they are, the spacings of those above are the
 * typical spacing times powers of the square root of two, each level thinned from the one below it. So a
 * surface loses half of its samples a level, and the whole costs two to three times the first.
 * \param[in] points distinct and in an order that depends on their coordinates only
 * \param[in] range where from is more than the typical spacing there is no level of the points themselves
 *
 * O (n log n). */
std::vector<ScaleLevel> makeLadder (const Eigen::Matrix3Xd& points, const ScaleRange& range);

} // namespace manifold
} // namespace pcl
