#pragma once

#include <Eigen/Core>

namespace pcl {
namespace manifold {

/** The circumcentre of a tetrahedron that is not flat. Where doubles lose too many digits (nearly flat ones)
 * it is computed in exact rational arithmetic and rounded once, so it is always finite and right to about
 * eight digits of its distance to the tetrahedron. One farther away than 1e150 is given in its direction at
 * that distance, so that squares of distances are finite, too. */
Eigen::Vector3d circumcenter (const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                              const Eigen::Vector3d& d);

/** The circumcentre of a triangle that is not degenerate, likewise. */
Eigen::Vector3d circumcenter (const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c);

/** The unit normal (b - a) x (c - a) of a triangle that is not degenerate, likewise. */
Eigen::Vector3d unitNormal (const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c);

} // namespace manifold
} // namespace pcl
