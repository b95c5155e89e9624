#pragma once

#include <pcl/manifold/simplicial_complex.h>
#include <pcl/manifold/topology_report.h>

#include <Eigen/Core>

#include <string>
#include <vector>

namespace generate {
struct Shape;
}

namespace benchmark {

/** \brief What a table says of a surface. */
struct SurfaceMeasures
{
  pcl::manifold::SurfaceTopology topology;
  double smallest_angle = 0.0;   ///< of a triangle, in degrees
  double percentile_angle = 0.0; ///< the smallest angle of all but one triangle in a hundred, in degrees
  double hausdorff = 0.0;        ///< distance to the surface that was sampled; negative where it is not known
};

/** \brief Measures a surface over points.
 * \param[in] shape that was sampled, or null where it is not known */
SurfaceMeasures measure (const std::vector<pcl::SimplicialComplex::Triangle>& triangles,
                         const Eigen::Matrix3Xd& points, const generate::Shape* shape);

} // namespace benchmark
