#pragma once

#include <cstddef>

namespace benchmark {

/** \brief Gives freed memory back, and forgets the peak of what was resident so far.
 * \return the bytes resident now; 0 where the system cannot forget its peak */
std::size_t resetPeakMemory ();

/** \brief The largest number of bytes resident since then. */
std::size_t peakMemory ();

} // namespace benchmark
