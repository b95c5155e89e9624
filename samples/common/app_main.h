#pragma once

#include "command_line.h"

#include <pcl/manifold/status.h>

#include <functional>
#include <string>

namespace pcl::manifold::apps {

/** \brief The main function of an app: reads the command line, prints the help if asked for, runs `body`, and
 * turns everything that it throws into one line on standard error, `error: FILE: what and where`.
 *
 * Messages of PCL itself are silenced, and the first Ctrl-C is noted (see interrupted ()).
 * \return the exit status: 0 done, 1 bad input or failure, 2 wrong usage */
int runApp (int argc, const char* const* argv, CommandLine& command_line, const std::function<void ()>& body);

/** \brief Throws AppError (`file`, why in words) unless the status is OK. */
void requireOk (const std::string& file, pcl::manifold::Status status);

} // namespace pcl::manifold::apps
