#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl {
namespace manifold {

/** So many nearest neighbours of every point are asked, those of kNearestNeighbors (). */
constexpr int NEAREST = 10;

/** The spacings at which a cloud is looked at, in the unit of the points. */
struct ScaleRange
{
  double from = 0.0; ///< the points themselves and, above, what is no finer; 0 = from the median spacing on
  double to = 0.0;   ///< none is coarser; 0 = an eighth of the largest extent of the bulk
};

/** One level of the ladder: the points as they look at a spacing. */
struct ScaleLevel
{
  double spacing = 0.0;     ///< no two samples were kept that are nearer than this
  Eigen::Matrix3Xd centers; ///< per sample the mean of all points that it stands for, which averages noise
  /// Per sample of the level below its sample here. Empty at the first level, whose samples are the points.
  std::vector<std::int32_t> sample_of;
};

/** The ladder of scales: its first level holds the points as they are, the spacings of those above are the
 * median spacing times powers of the square root of two, each level thinned from the one below it. So a
 * surface loses half of its samples a level, and the whole costs two to three times the first.
 * \param[in] points distinct and in an order that depends on their coordinates only
 * \param[in] range the first level is the points themselves whatever it says
 *
 * O (n log n). */
std::vector<ScaleLevel> makeLadder (const Eigen::Matrix3Xd& points, const ScaleRange& range);

} // namespace manifold
} // namespace pcl
