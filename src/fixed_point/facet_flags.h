#pragma once

#include <pcl/manifold/fixed_point_complex.h>

#include "extraction/facet_set.h"

#include <vector>

namespace pcl {
namespace manifold {

/** Flags for every cell, none of them set. */
FacetFlags noFacets (const DelaunayComplex& complex);

/** A triangle as the facet of its cell with the smaller number, given as that of either cell. */
Facet canonicalFacet (const DelaunayComplex& complex, const Facet& facet);

/** Sets the flag of a triangle.
 * \return whether it was not set before */
bool setFacet (const DelaunayComplex& complex, const Facet& facet, FacetFlags& flags);

/** The triangles of a set in ascending order, each as the facet of its cell with the smaller number. */
std::vector<Facet> facetsOf (const DelaunayComplex& complex, const FacetFlags& flags);

} // namespace manifold
} // namespace pcl
