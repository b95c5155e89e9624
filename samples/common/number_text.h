#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace pcl::manifold::apps {

/** \brief Reads one number that fills all of `text`, whatever the locale. An integer type takes no fraction,
 * no overflow, and, when unsigned, no minus; a floating-point type takes `nan` and `inf` too.
 * \return false, and leaves `value` as it was, if `text` is no such number */
template <typename T>
bool parseNumber (std::string_view text, T& value);

/** \brief Reads one number into the bytes at `to`, as the type `datatype` (of pcl::PCLPointField).
 * \return false if `text` is no number of that type */
bool parseField (std::string_view text, std::uint8_t datatype, std::uint8_t* to);

/** \brief Reads the number at `from`, stored as the type `datatype` (of pcl::PCLPointField). */
double fieldAsDouble (std::uint8_t datatype, const std::uint8_t* from);

/** \brief Splits a line at white space (and at commas and semicolons, if asked for).
 * \param[out] tokens the parts, none of them empty; they point into `line` */
void splitLine (std::string_view line, bool at_commas, std::vector<std::string_view>& tokens);

} // namespace pcl::manifold::apps
