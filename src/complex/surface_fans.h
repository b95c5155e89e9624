#pragma once

#include "complex/surface_sides.h"

#include <cstdint>
#include <vector>

namespace pcl {
namespace manifold {

/** \brief One fan: faces around a vertex that hang together through edges of exactly two faces. */
struct SurfaceFan
{
  std::uint32_t vertex;
  std::uint32_t face;    ///< one of its faces
  bool closed;           ///< once around the vertex; otherwise it ends in the two sides below
  std::uint32_t ends[2]; ///< sides of edges of one face, or of more than two
};

/** \brief Every corner of every face is in one fan. A vertex is a manifold one if it has one fan and no edge
 * of more than two faces. */
std::vector<SurfaceFan> findFans (const SurfaceSides& sides);

} // namespace manifold
} // namespace pcl
