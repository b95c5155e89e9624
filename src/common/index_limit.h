#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

namespace pcl {
namespace manifold {

/** Points and cells are numbered by 32 bits with a sign, as in PCL: from 0 to one less than this. Whatever is
 * counted per corner of a cell, or per neighbour of a point, is counted by 64 bits. */
constexpr std::uint64_t MOST_INDICES = INT32_MAX;

/** Whether so many things can be numbered. */
constexpr bool
fitsIndices (std::uint64_t count, std::uint64_t most = MOST_INDICES)
{
  return count <= most;
}

/** \throws std::length_error, of which guarded () makes Status::TOO_MANY_POINTS, if they cannot. */
inline void
requireIndices (std::uint64_t count, const char* of_what, std::uint64_t most = MOST_INDICES)
{
  if (!fitsIndices (count, most))
    throw std::length_error (std::to_string (count) + " " + of_what + " are too many for 32-bit indices");
}

} // namespace manifold
} // namespace pcl
