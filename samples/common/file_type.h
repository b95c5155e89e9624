#pragma once

#include <initializer_list>
#include <string>

namespace pcl::manifold::apps {

/** \brief The end of a file's name from its last dot on, in lower case; empty if there is none. */
std::string fileType (const std::string& file);

/** \brief Checks the name of a file that the user gave.
 * \param[in] argument what the user gave it as: OUTPUT, -picture
 * \param[in] file its name
 * \param[in] types what it may end in, such as ".pcd"
 * \throws UsageError if it ends in none of them */
void requireType (const std::string& argument, const std::string& file,
                  std::initializer_list<std::string> types);

} // namespace pcl::manifold::apps
