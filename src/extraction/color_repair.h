#pragma once

#include "extraction/surface_candidates.h"

#include <cstdint>
#include <vector>

namespace pcl {
namespace manifold {

/** Whether the surface where the colour changes, with its infinite triangles, passes through a sample
 * otherwise than as one disk. */
bool crossesItself (const DelaunayComplex& complex, const std::vector<std::uint8_t>& colors,
                    std::int32_t sample);

/** Changes the colours of a few cells until the surface where the colour changes is a manifold at every
 * sample: then it is edge- and vertex-manifold everywhere. At a sample with several components of a colour
 * the smallest one changes over; where that does not settle, all its cells get colour 0, so that the surface
 * leaves the sample.
 *
 * \param[in] closed if false, samples of curves and inside of solids, and those at which the candidate
 * triangles among the surface's are a manifold already, are left alone: the surface in free space, which is
 * not kept, may cross itself. If true, the infinite cells must have colour 0 and keep it.
 * \return the number of samples that the surface was taken from */
std::size_t repairColors (const SurfaceCandidates& candidates, bool closed,
                          std::vector<std::uint8_t>& colors);

/** Brings samples of surfaces, around which all cells have one colour, onto the surface: a cell between the
 * sample and a triangle of the surface changes over, which splits the triangle in three. The surface stays a
 * manifold.
 * \return the number of samples that are still not on it */
std::size_t insertSamples (const SampleDimensions& dimensions, const std::vector<Role>& roles,
                           std::vector<std::uint8_t>& colors);

} // namespace manifold
} // namespace pcl
