#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace manifold {

/** Finds the place, if there is one, at which a sensor's driver stored the rays that met nothing: many points
 * that coincide, at the zero of the coordinates or, if the cloud was moved since, at another place, apart
 * from all others.
 *
 * The place is that of most coincident points. Of two points on at zero are enough where nothing else
 * coincides; otherwise there must be more than four times as many, and elsewhere sixteen times as many, as at
 * any other place. And the place must be farther from all other points but seven than five times the
 * median of the distances of the points to their nearest ones, elsewhere sixteen times: the pole of a lathe,
 * where a ring of points is one, is as near to the next ring as rings are.
 *
 * \param[in] points distinct, in an order that depends on the coordinates only
 * \param[in] counts how many points of the cloud are at each
 * \param[in] zero the zero of the cloud's coordinates
 * \return its number, or -1 */
std::int32_t findNoMeasurement (const Eigen::Matrix3Xd& points, const std::vector<std::int32_t>& counts,
                                const Eigen::Vector3d& zero);

} // namespace manifold
} // namespace pcl
