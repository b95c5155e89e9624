#pragma once

#include <pcl/PCLPointCloud2.h>

#include <array>
#include <cstddef>
#include <string>

namespace pcl::manifold::apps {

/** \brief What makeCoordinatesFloat () did to the coordinates. */
struct CoordinateShift
{
  std::array<double, 3> origin{}; ///< was subtracted; zeros, unless the cloud was shifted
  std::size_t no_measurement = 0; ///< points at (0, 0, 0), far from all others, that became NaN
};

/** \brief Makes x, y and z three FLOAT32 fields, as pcl::PointXYZ and all of PCL needs them. Fields that are
 * so already are left bit for bit. Others (doubles, integers) are converted, after the whole cloud was
 * shifted to the rounded middle of its bulk where floats would not resolve it otherwise, as for map
 * coordinates. Points far away from the bulk have no part in that. Two or more of them at exactly (0, 0, 0)
 * are rays without measurement, which would be at any place after the shift, and become NaN.
 * \param[in] file name of the cloud's file, for messages
 * \throws AppError if one of the fields is missing or holds more than one value per point */
CoordinateShift makeCoordinatesFloat (pcl::PCLPointCloud2& cloud, const std::string& file);

} // namespace pcl::manifold::apps
