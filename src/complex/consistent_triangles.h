#pragma once

#include <pcl/manifold/simplicial_complex.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace manifold {

/** \brief The patches of triangles that agree in their directions already. */
struct ConsistentPatches
{
  std::vector<std::uint32_t> patch;       ///< of each triangle; numbered by their first triangles
  std::vector<std::uint8_t> has_boundary; ///< per patch: has it an edge of one triangle?
};

/** \brief Do all triangles that share an edge of exactly two agree in their directions? That is what an
 * extraction that knows both sides of a surface gives, and is found out faster, and in parallel, than
 * SurfacePatches are.
 * \param[in] triangles any
 * \param[in] vertices indices from here on, repeated and negative ones make the answer no
 * \param[out] patches for the answer yes */
bool findConsistentPatches (const std::vector<SimplicialComplex::Triangle>& triangles, std::size_t vertices,
                            ConsistentPatches& patches);

} // namespace manifold
} // namespace pcl
