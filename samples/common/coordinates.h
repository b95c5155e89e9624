#pragma once

#include <pcl/PCLPointCloud2.h>

#include <array>
#include <string>

namespace pcl::manifold::apps {

/** \brief Makes x, y and z three FLOAT32 fields, as pcl::PointXYZ and all of PCL needs them. Fields that are
 * so already are left bit for bit. Others (doubles, integers) are converted, after the whole cloud was
 * shifted to its rounded middle where floats would not resolve it otherwise, as for map coordinates.
 * \param[in] file name of the cloud's file, for messages
 * \return what was subtracted from the coordinates; zeros, unless the cloud was shifted
 * \throws AppError if one of the fields is missing or holds more than one value per point */
std::array<double, 3> makeCoordinatesFloat (pcl::PCLPointCloud2& cloud, const std::string& file);

} // namespace pcl::manifold::apps
