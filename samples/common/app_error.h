#pragma once

#include <stdexcept>
#include <string>

namespace pcl::manifold::apps {

/** \brief A failure that the user is told of in one line, `error: FILE: what and where`; exit status 1. */
class AppError : public std::runtime_error
{
public:
  /** \param[in] file the file that the failure is about
   * \param[in] what what is wrong and where, in one line */
  AppError (const std::string& file, const std::string& what) : std::runtime_error (file + ": " + what) {}
};

/** \brief Wrong usage of the command line; exit status 2. */
class UsageError : public std::runtime_error
{
public:
  /** \param[in] option the option or the positional argument, as the user types it
   * \param[in] what what is wrong with it, in one line */
  UsageError (const std::string& option, const std::string& what) : std::runtime_error (option + ": " + what)
  {}
};

} // namespace pcl::manifold::apps
