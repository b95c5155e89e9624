#pragma once

#include "extraction/facet_set.h"

#include <vector>

namespace pcl {
namespace manifold {

/** Inserts triangles into a surface one after the other, smallest circumcircle first, as long as that leaves
 * at most two triangles at every edge, at every sample nothing but fans or one disk, and no two triangles
 * folded onto each other. What does not fit is tried again after the others until nothing fits any more.
 * Where fans of one sample do not meet in the end, all but the largest are erased. */
void insertFitting (std::vector<Facet> candidates, FacetSet& surface);

} // namespace manifold
} // namespace pcl
