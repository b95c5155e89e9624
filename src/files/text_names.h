#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace pcl::manifold {

/** \brief The words of a comment, without what marks it: `#`, `//` or `%`.
 * \return false if the line is no comment */
bool isComment (std::string_view line, std::string_view& words);

/** \brief The names of the columns in a line ahead of the points.
 * \param[in] line may be a comment
 * \param[in] separator that of the points; the names may have another
 * \return none if there is not one name a column */
std::vector<std::string> parseNames (std::string_view line, char separator, std::size_t columns);

/** \brief The fields that columns with these names make, none twice and without blanks.
 * \param[in] names one a column, or none
 * \return one a column, x, y and z among them: the first three, if the names do not say otherwise */
std::vector<std::string> fieldNames (const std::vector<std::string>& names, std::size_t columns);

} // namespace pcl::manifold
