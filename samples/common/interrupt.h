#pragma once

#include <string>

namespace pcl::manifold::apps {

/** \brief From now on the first Ctrl-C (SIGINT) or SIGTERM is only noted; a second one ends the program. */
void noteInterrupts ();

/** \brief Was there one? */
bool interrupted ();

/** \brief Throws AppError (`file`, "cancelled") if there was one. */
void throwIfInterrupted (const std::string& file);

} // namespace pcl::manifold::apps
