#pragma once

#include <Eigen/Core>

namespace pcl {
namespace manifold {

/** \file
 * Exact decisions about points and Voronoi cells: doubles first, and numbers without rounding wherever these
 * leave a doubt. Any finite coordinates will do. */

/** Whether p (-1) or q (1) is nearer to a point, or none of them (0). */
int nearer (const Eigen::Vector3d& point, const Eigen::Vector3d& p, const Eigen::Vector3d& q);

/** Where a segment leaves the Voronoi cell of p: whether it crosses the bisector with q (-1) or that with r
 * (1) first, or both at once (0).
 * \param[in] from a point not nearer to q or r than to p
 * \param[in] to a point nearer to q and nearer to r than to p */
int crossesFirst (const Eigen::Vector3d& from, const Eigen::Vector3d& to, const Eigen::Vector3d& p,
                  const Eigen::Vector3d& q, const Eigen::Vector3d& r);

/** Whether a point is outside of the ball with the diameter p q, and not on it. */
bool isOutsideBall (const Eigen::Vector3d& point, const Eigen::Vector3d& p, const Eigen::Vector3d& q);

} // namespace manifold
} // namespace pcl
