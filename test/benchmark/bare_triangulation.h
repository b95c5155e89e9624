#pragma once

#include <Eigen/Core>

namespace benchmark {

/** \brief Seconds that CGAL's 3D Delaunay triangulation of points takes, nothing else: the floor of the
 * Delaunay family.
 * \param[in] parallel with TBB and CGAL's lock data structure
 * \param[out] cells finite and infinite */
double bareTriangulation (const Eigen::Matrix3Xd& points, bool parallel, std::size_t& cells);

} // namespace benchmark
