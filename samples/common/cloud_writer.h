#pragma once

#include <pcl/PCLPointCloud2.h>

#include <array>
#include <string>

namespace pcl::manifold::apps {

/** \brief Writes a cloud as a binary PCD file, every field bit for bit, padding left out, atomically.
 * \param[in] file its name
 * \param[in] cloud the points
 * \param[in] viewpoint translation and quaternion (w, x, y, z) of the sensor
 * \throws AppError if it cannot be written; nothing is left then, and an older file of that name stays */
void writePcd (const std::string& file, const pcl::PCLPointCloud2& cloud,
               const std::array<double, 7>& viewpoint = {0, 0, 0, 1, 0, 0, 0});

} // namespace pcl::manifold::apps
