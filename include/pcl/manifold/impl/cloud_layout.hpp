#pragma once

#include <pcl/point_cloud.h>
#include <pcl/types.h>

#include <cstddef>

namespace pcl {
namespace manifold {

/** \brief Gives a cloud of one answer for every index the header and the sensor's pose of the cloud that was asked
 * of, and its width and height if the indices name all of its points in their order. */
template <typename PointT, typename Answer>
void
copyLayout (const pcl::PointCloud<PointT>& cloud, const pcl::Indices& indices,
            pcl::PointCloud<Answer>& answers)
{
  answers.header = cloud.header;
  answers.sensor_origin_ = cloud.sensor_origin_;
  answers.sensor_orientation_ = cloud.sensor_orientation_;
  bool in_place =
    indices.size () == cloud.size () && std::size_t (cloud.width) * cloud.height == cloud.size ();
  for (std::size_t i = 0; in_place && i < indices.size (); ++i)
    in_place = static_cast<std::size_t> (indices[i]) == i;
  if (in_place) {
    answers.width = cloud.width;
    answers.height = cloud.height;
  }
}

} // namespace manifold
} // namespace pcl
