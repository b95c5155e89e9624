#pragma once

#include "extraction/facet_set.h"
#include "extraction/surface_candidates.h"

#include <vector>

namespace pcl {
namespace manifold {

/** Grows a surface that is manifold at every sample over the candidate triangles of those surface samples
 * that have no triangle yet, where more than a few of them are together: smallest circumcircle first, never
 * so that a triangle breaks the manifold or folds back over another. Afterwards the surface is manifold at
 * every sample again. */
void growSurface (const SurfaceCandidates& candidates, FacetSet& surface);

/** Fills the loops of a surface that have a few edges only with Delaunay triangles between their samples,
 * likewise. */
void fillSmallLoops (const std::vector<Role>& roles, FacetSet& surface);

/** The loops of boundary edges of a surface that is manifold at every sample, each as its samples in order.
 */
std::vector<std::vector<std::int32_t>> boundaryLoops (const FacetSet& surface);

} // namespace manifold
} // namespace pcl
