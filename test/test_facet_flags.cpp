// Sets of Delaunay triangles as flags of facets.
#include "oracle_fixed_point.h"

#include "fixed_point/facet_flags.h"

#include <gtest/gtest.h>

namespace {

using namespace oracle;
using pcl::manifold::Facet;
using pcl::manifold::FacetFlags;
using pcl::manifold::facetsOf;

// A flag can be asked of either cell.
TEST (FacetFlags, AreSetFromBothSides)
{
  forEachLattice (4, 4, 30, [] (const Eigen::Matrix3Xd& cloud, int) {
    const auto complex = complexOf (cloud);
    const RestrictedOracle expected (*complex);
    FacetFlags flags = pcl::manifold::noFacets (*complex);
    for (const Facet& facet : expected.facets) {
      const std::int32_t other = complex->neighbors[facet.cell][facet.facet];
      const int mirror = mirrorFacet (*complex, facet.cell, facet.facet);
      ASSERT_FALSE (flags.contains (other, mirror));
      ASSERT_TRUE (setFacet (*complex, facet, flags));
      ASSERT_TRUE (flags.contains (facet.cell, facet.facet) && flags.contains (other, mirror));
      ASSERT_FALSE (setFacet (*complex, {other, mirror}, flags));
    }
    ASSERT_TRUE (facetsOf (*complex, flags) == expected.facets);
    for (const Facet& facet : expected.facets)
      ASSERT_TRUE (canonicalFacet (*complex, {complex->neighbors[facet.cell][facet.facet],
                                              mirrorFacet (*complex, facet.cell, facet.facet)}) == facet);
  });
}

} // namespace
