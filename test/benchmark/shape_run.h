#pragma once

#include <pcl/manifold/stage_log.h>

#include <Eigen/Core>

#include <cstddef>
#include <string>
#include <vector>

namespace benchmark {

/** \brief Can samplePoints sample it: sphere, torus or genus3? */
bool isShape (const std::string& name);

/** \brief About so many points of a surface, rounded to floats as PCL's are.
 * \param[in] noise in spacings; 0 = a clean blue noise sample */
Eigen::Matrix3Xd samplePoints (const std::string& name, std::size_t count, double noise);

/** \brief A whole run of COCONESHAPE. */
struct ShapeRun
{
  double seconds = 0.0;
  double dimension_seconds = 0.0; ///< those of DIMENSION, its first stages
  std::vector<pcl::manifold::Stage> stages;
};

ShapeRun runShape (const Eigen::Matrix3Xd& points, unsigned int threads);

} // namespace benchmark
