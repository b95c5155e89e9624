#pragma once

#include "complex/surface_sides.h"

#include <cstdint>
#include <vector>

namespace pcl {
namespace manifold {

/** \brief The patches of a surface: faces that hang together through edges of exactly two faces, and how to
 * turn them so that neighbours agree. */
struct SurfacePatches
{
  std::vector<std::uint32_t> patch;       ///< of each face; numbered by their first faces
  std::vector<std::uint8_t> turned;       ///< is the face to be turned to agree with the first of its patch?
  std::vector<std::uint8_t> orientable;   ///< per patch
  std::vector<std::uint8_t> has_boundary; ///< per patch: has it an edge of one face?

  explicit SurfacePatches (const SurfaceSides& sides);
};

} // namespace manifold
} // namespace pcl
