#pragma once

#include <pcl/PCLPointCloud2.h>

#include <array>
#include <string>

namespace pcl::manifold::apps {

/** \brief Reads a PCD file, of text, binary or compressed data, with every field but padding.
 * \param[out] viewpoint translation and quaternion (w, x, y, z) of the sensor, as in the header
 * \throws AppError if the file is missing, truncated or corrupt; it says where */
pcl::PCLPointCloud2 readPcd (const std::string& file, std::array<double, 7>& viewpoint);

} // namespace pcl::manifold::apps
