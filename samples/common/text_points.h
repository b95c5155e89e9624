#pragma once

#include "input_file.h"

#include <pcl/PCLPointCloud2.h>

#include <string_view>
#include <vector>

namespace pcl::manifold::apps {

/** \brief Reads every word as a number.
 * \return false if there is none, or one is no number */
bool parseNumbers (const std::vector<std::string_view>& words, std::vector<double>& numbers);

/** \brief A cloud with the FLOAT64 fields x, y, z, column_4, column_5, ...
 * \param[in] values the numbers of all points, one point after the other
 * \param[in] columns number of values in a point, at least 3
 * \throws AppError if there are more points than PCL can hold */
pcl::PCLPointCloud2 cloudOfColumns (const InputFile& file, const std::vector<double>& values,
                                    std::size_t columns);

} // namespace pcl::manifold::apps
