#pragma once

#include "extraction/sample_roles.h"

#include <cstdint>
#include <vector>

namespace pcl {
namespace manifold {

/** Which cells solids can be made of, a flag per cell. */
struct SolidCells
{
  /// Between samples of solids or their skins, and no larger than the spacing there allows.
  std::vector<std::uint8_t> possible;
  /// Likewise, and at a sample inside of a solid: the candidates of COCONESHAPE.
  std::vector<std::uint8_t> certain;
};

SolidCells findSolidCells (const SampleDimensions& dimensions, const std::vector<Role>& roles);

/** The cells that make up solids, as a flag per cell: the certain ones, and the possible ones of the same
 * colour next to them.
 * \param[in] closed solids are whole regions of one colour instead, so that their boundary is part of the
 * surface where the colour changes The boundary of the result is a manifold at every sample. */
std::vector<std::uint8_t> findSolids (const SampleDimensions& dimensions, const std::vector<Role>& roles,
                                      const SolidCells& cells, const std::vector<std::uint8_t>& colors,
                                      bool closed);

} // namespace manifold
} // namespace pcl
