#pragma once

#include "extraction/sample_roles.h"

#include <cstdint>
#include <vector>

namespace pcl {
namespace manifold {

/** The finite cells that make up solids, as a flag per cell. They grow from the cells at samples inside of a
 * solid, which are the candidates of COCONESHAPE, over cells of the same colour; a region that reaches the
 * outside that way is cut back to the candidates. The boundary of the result is a manifold at every sample.
 */
std::vector<std::uint8_t> findSolids (const SampleDimensions& dimensions, const std::vector<Role>& roles,
                                      const std::vector<std::uint8_t>& colors);

} // namespace manifold
} // namespace pcl
