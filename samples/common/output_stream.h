#pragma once

#include <functional>
#include <ostream>
#include <string>

namespace pcl::manifold::apps {

/** \brief Writes a file through a stream, atomically.
 * \param[in] write is given the open, binary stream; it need not look at the stream's state
 * \throws AppError that gives the reason, a full disk for example; nothing is left then */
void writeStream (const std::string& file, const std::function<void (std::ostream&)>& write);

} // namespace pcl::manifold::apps
