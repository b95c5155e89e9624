#pragma once

#include <pcl/manifold/cloud_graph.h>

namespace pcl {
namespace manifold {

/** Finds the distinct finite points of a cloud and their order: everything of a CloudGraph but the graph.
 * Parameters as of makeCloudGraph. */
Status findVertices (Eigen::MatrixXd points, const pcl::Indices& indices, double resolution,
                     CloudGraph& cloud);

} // namespace manifold
} // namespace pcl
