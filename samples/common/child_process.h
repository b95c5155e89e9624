#pragma once

#include <chrono>

#include <sys/types.h>

namespace pcl::manifold::apps {

/** \brief Waits for a child process to end.
 * \param[out] status as waitpid () gives it
 * \return false if it has not ended within `patience` */
bool waitFor (pid_t process, std::chrono::milliseconds patience, int& status);

/** \brief To be called in a child process that was just forked: it is ended together with its parent, left
 * alone by Ctrl-C, and what it prints goes nowhere. */
void becomeQuietChild (pid_t parent);

} // namespace pcl::manifold::apps
