#pragma once

#include "extraction/facet_set.h"
#include "extraction/sample_roles.h"

#include <cstdint>
#include <vector>

namespace pcl {
namespace manifold {

/** Flags the samples of those triangles across which the colour changes in the middle of free space and which
 * are no candidates. That happens beside a surface with one side only, as a Moebius band is: its two colours
 * have to meet somewhere. */
std::vector<std::uint8_t> findSeams (const SampleDimensions& dimensions, const std::vector<Role>& roles,
                                     const std::vector<Facet>& torn);

/** Erases the components of a surface that such a seam crosses. What is erased is left to growSurface, which
 * needs no sides. \return the number of samples that the surface was taken from */
std::size_t eraseOneSided (const std::vector<std::uint8_t>& seams, FacetSet& surface);

} // namespace manifold
} // namespace pcl
