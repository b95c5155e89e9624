#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace pcl::manifold {

/** \brief Splits a line.
 * \param[in] separator a blank stands for any white space; fields between other separators may be empty, but
 * for one behind the last separator
 * \param[out] words the parts, without white space around them; they point into `line` */
void splitAt (std::string_view line, char separator, std::vector<std::string_view>& words);

/** \brief How the numbers of a line are written. */
struct Notation
{
  char separator = ' '; ///< `;`, `,` or a blank for white space
  char mark = '\0';     ///< `.` or `,` ahead of decimals; 0 where there are none
};

/** \brief Reads the numbers of a line.
 *
 * A comma separates where nothing but commas does and three numbers or more come out; otherwise it stands
 * ahead of decimals. An empty field between two separators is a NaN.
 * \param[out] numbers empty if the line holds anything but numbers, or is written in more than one way
 * \throw FileError, without a line, if its commas may be either */
Notation parseLine (std::string_view line, std::vector<double>& numbers);

} // namespace pcl::manifold
