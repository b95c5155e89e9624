#pragma once

#include <pcl/types.h>

#include <cstdint>

namespace pcl {
namespace manifold {

/** The priority of a vertex, lowest first: numbers that look random even for seeds and vertices in a row (two
 * rounds of the finalizer of splitmix64), and that differ between the vertices of one seed. */
inline std::uint64_t
priorityOf (pcl::index_t vertex, std::uint64_t seed)
{
  const auto mix = [] (std::uint64_t x) {
    x += 0x9e3779b97f4a7c15ULL;
    x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9ULL;
    x = (x ^ x >> 27) * 0x94d049bb133111ebULL;
    return x ^ x >> 31;
  };
  return mix (mix (seed) + static_cast<std::uint64_t> (vertex));
}

} // namespace manifold
} // namespace pcl
