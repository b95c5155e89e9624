#pragma once

#include <pcl/point_cloud.h>
#include <pcl/types.h>

#include <Eigen/Core>

namespace pcl {
namespace manifold {

/** \brief The coordinates of those points of a cloud that the indices name, as doubles. */
template <typename PointT>
Eigen::Matrix3Xd
cloudPoints (const pcl::PointCloud<PointT>& cloud, const pcl::Indices& indices)
{
  Eigen::Matrix3Xd points (3, static_cast<Eigen::Index> (indices.size ()));
  for (std::size_t i = 0; i < indices.size (); ++i)
    points.col (i) = cloud[indices[i]].getVector3fMap ().template cast<double> ();
  return points;
}

/** \brief Whether every index names a point of the cloud. */
template <typename PointT>
bool
areValid (const pcl::PointCloud<PointT>& cloud, const pcl::Indices& indices)
{
  for (const pcl::index_t index : indices)
    if (index < 0 || static_cast<std::size_t> (index) >= cloud.size ())
      return false;
  return true;
}

} // namespace manifold
} // namespace pcl
