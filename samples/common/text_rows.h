#pragma once

#include "input_file.h"

#include <pcl/PCLPointCloud2.h>

#include <string>
#include <vector>

namespace pcl::manifold::apps {

/** \brief Reads the points of a cloud from lines of text: one point a line, one number for every value of
 * every field. Empty lines are skipped.
 * \param[in,out] cloud fields, width and height are given; the data is allocated and filled
 * \param[in] what what a line holds, for messages
 * \throws AppError that names the first line that does not fit, or says that lines are missing */
void readTextRows (InputFile& file, pcl::PCLPointCloud2& cloud, const std::string& what);

} // namespace pcl::manifold::apps
