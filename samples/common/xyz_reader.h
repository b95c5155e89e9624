#pragma once

#include <pcl/PCLPointCloud2.h>

#include <string>
#include <vector>

namespace pcl::manifold::apps {

/** \brief Reads points from text, one a line: `x y z` and any further numbers, separated by white space,
 * commas or semicolons. What follows a `#`, and empty lines, are skipped.
 *
 * The first line that holds three or more numbers and nothing else says how many there are in a line; further
 * ones become the fields `column_4`, `column_5` and so on. All fields are FLOAT64. Lines that do not conform
 * are skipped, counted and reported.
 * \param[out] notes what the user should know: how many lines were skipped, and which came first
 * \throws AppError if the file cannot be read or no line of it conforms */
pcl::PCLPointCloud2 readXyz (const std::string& file, std::vector<std::string>& notes);

} // namespace pcl::manifold::apps
