#pragma once

#include <pcl/manifold/simplicial_complex.h>

#include <Eigen/Core>

#include <vector>

namespace benchmark {

/** \brief CGAL's advancing front surface reconstruction, with its own triangulation.
 * \param[in] points finite */
std::vector<pcl::SimplicialComplex::Triangle> advancingFront (const Eigen::Matrix3Xd& points);

} // namespace benchmark
