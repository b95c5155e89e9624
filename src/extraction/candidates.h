#pragma once

#include "extraction/sample_roles.h"

#include <pcl/manifold/simplicial_complex.h>

#include <cstdint>
#include <vector>

namespace pcl {
namespace manifold {

/** Whether a Delaunay triangle, given as a facet of a cell, is a candidate for a surface: its dual Voronoi
 * edge meets the cocone of one of its surface samples. */
bool isCandidate (const SampleDimensions& dimensions, const std::vector<Role>& roles, std::int32_t cell,
                  int facet);

/** Whether the candidate triangles at a sample across which the colour changes form one disk or half-disk. */
bool candidatesAreManifold (const SampleDimensions& dimensions, const std::vector<Role>& roles,
                            const std::vector<std::uint8_t>& colors, std::int32_t sample);

/** All candidate simplices of COCONESHAPE as published (section 5 of Dey, Giesen, Goswami and Zhao): for
 * every sample of published dimension k the k-simplices at it dual to the Voronoi faces that its cocone
 * meets. Indices are those of samples; every simplex once, its samples in ascending order. */
SimplicialComplex collectCandidates (const SampleDimensions& dimensions);

} // namespace manifold
} // namespace pcl
