// A set of Delaunay triangles against a std::set of triples.
#include "oracle_exact.h"
#include "oracle_surface.h"

#include <gtest/gtest.h>

#include <set>

namespace {

using namespace oracle;
using pcl::manifold::DelaunayComplex;
using pcl::manifold::Facet;
using pcl::manifold::facetOf;
using pcl::manifold::FacetSet;
using pcl::manifold::Fan;
using pcl::manifold::mirrorFacet;
using pcl::manifold::oppositeSide;
using Triple = std::array<std::int32_t, 3>;

Triple
sorted (Triple triangle)
{
  std::sort (triangle.begin (), triangle.end ());
  return triangle;
}

TEST (FacetSet, FacetsLieOppositeOfTheirVertices)
{
  forEachLattice (20, 3, 30, [] (const Eigen::Matrix3Xd& cloud, int kind) {
    const auto complex = complexOf (cloud);
    for (std::size_t i = 0; i < complex->cells.size (); ++i)
      for (int k = 0; k < 4; ++k) {
        const auto cell = static_cast<std::int32_t> (i);
        const Triple triangle = facetOf (*complex, cell, k);
        const std::int32_t opposite = complex->cells[i][static_cast<std::size_t> (k)];
        ASSERT_EQ (std::count (triangle.begin (), triangle.end (), opposite), 0);
        const std::int32_t neighbor = complex->neighbors[i][static_cast<std::size_t> (k)];
        const int mirror = mirrorFacet (*complex, cell, k);
        ASSERT_EQ (complex->neighbors[static_cast<std::size_t> (neighbor)][static_cast<std::size_t> (mirror)],
                   cell);
        ASSERT_EQ (sorted (facetOf (*complex, neighbor, mirror)), sorted (triangle)) << kind;
        ASSERT_EQ (mirrorFacet (*complex, neighbor, mirror), k);
        if (*std::min_element (triangle.begin (), triangle.end ()) < 0)
          continue;
        // Counterclockwise from outside: the fourth vertex is behind.
        ASSERT_TRUE (opposite < 0 ||
                     orientation<Integer> (cloud.col (triangle[0]), cloud.col (triangle[1]),
                                           cloud.col (triangle[2]), cloud.col (opposite)) < 0);
        for (const std::int32_t vertex : triangle) {
          const std::array<std::int32_t, 2> side = oppositeSide (*complex, cell, k, vertex);
          ASSERT_EQ (sorted ({vertex, side[0], side[1]}), sorted (triangle));
        }
      }
  });
}

// What the set has at a sample, against all triples of the list.
void
compareAt (const FacetSet& surface, const std::set<Triple>& listed, std::int32_t sample,
           std::uint8_t coverage)
{
  std::multiset<Triple> at;
  surface.forEachAt (sample, [&] (std::int32_t cell, int facet) {
    at.insert (sorted (facetOf (surface.complex (), cell, facet)));
  });
  std::multiset<Triple> expected;
  Fan expected_fan;
  for (const Triple& triangle : listed)
    for (std::size_t k = 0; k < 3; ++k)
      if (triangle[k] == sample) {
        expected.insert (triangle);
        expected_fan.add (triangle[(k + 1) % 3], triangle[(k + 2) % 3]);
      }
  ASSERT_EQ (at, expected);
  Fan fan;
  surface.fanAt (sample, fan);
  ASSERT_EQ (fan.size (), expected.size ());
  for (std::int32_t v = 0; v < surface.complex ().samples->size (); ++v)
    ASSERT_EQ (fan.degree (v), expected_fan.degree (v));
  ASSERT_EQ ((coverage & FacetSet::COVERED) != 0, !expected.empty ());
  ASSERT_TRUE (expected.empty () || !expected_fan.isManifold () ||
               ((coverage & FacetSet::OPEN) != 0) == !expected_fan.isClosed ());
}

TEST (FacetSet, KeepsWhatIsInserted)
{
  forEachLattice (15, 3, 25, [] (const Eigen::Matrix3Xd& cloud, int kind) {
    const auto complex = complexOf (cloud);
    if (complex->affine_dimension < 2)
      return;
    SCOPED_TRACE (kind);
    Random random (static_cast<std::uint64_t> (cloud.cols ()));
    std::vector<Facet> facets = finiteFacets (*complex);
    FacetSet surface (*complex);
    std::set<Triple> listed;
    for (int step = 0; step < static_cast<int> (2 * facets.size ()); ++step) {
      Facet facet = facets[static_cast<std::size_t> (random.index (static_cast<int> (facets.size ())))];
      const Triple triangle = sorted (facetOf (*complex, facet.cell, facet.facet));
      if (random.coin ()) // from the other side
        facet = {
          complex->neighbors[static_cast<std::size_t> (facet.cell)][static_cast<std::size_t> (facet.facet)],
          mirrorFacet (*complex, facet.cell, facet.facet)};
      ASSERT_EQ (surface.contains (facet.cell, facet.facet), listed.count (triangle) != 0);
      if (random.index (3) != 0) {
        surface.insert (facet.cell, facet.facet);
        listed.insert (triangle);
      } else {
        surface.erase (facet.cell, facet.facet);
        listed.erase (triangle);
      }
    }
    const std::vector<std::uint8_t> coverage = surface.coverage ();
    for (std::int32_t sample = 0; sample < cloud.cols (); ++sample)
      compareAt (surface, listed, sample, coverage[static_cast<std::size_t> (sample)]);
    std::multiset<Triple> triangles;
    for (const Triple& triangle : surface.triangles ([] (std::int32_t) { return false; }))
      triangles.insert (sorted (triangle));
    ASSERT_EQ (triangles, std::multiset<Triple> (listed.begin (), listed.end ()));
  });
}

TEST (FacetSet, TurnsTrianglesAwayFromTheFirstCell)
{
  forEachLattice (15, 5, 25, [] (const Eigen::Matrix3Xd& cloud, int kind) {
    const auto complex = complexOf (cloud);
    if (complex->affine_dimension != 3)
      return;
    Random random (static_cast<std::uint64_t> (kind));
    std::vector<std::uint8_t> first (complex->cells.size ());
    for (std::uint8_t& flag : first)
      flag = random.coin () ? 1 : 0;
    FacetSet surface (*complex);
    std::set<Triple> expected;
    for (const Facet& facet : finiteFacets (*complex)) {
      const std::int32_t neighbor =
        complex->neighbors[static_cast<std::size_t> (facet.cell)][static_cast<std::size_t> (facet.facet)];
      surface.insert (facet.cell, facet.facet);
      const bool from_neighbor =
        first[static_cast<std::size_t> (neighbor)] && !first[static_cast<std::size_t> (facet.cell)];
      expected.insert (from_neighbor
                         ? facetOf (*complex, neighbor, mirrorFacet (*complex, facet.cell, facet.facet))
                         : facetOf (*complex, facet.cell, facet.facet));
    }
    const std::vector<Triple> triangles = surface.triangles (
      [&first] (std::int32_t cell) { return first[static_cast<std::size_t> (cell)] != 0; });
    ASSERT_EQ (std::set<Triple> (triangles.begin (), triangles.end ()), expected);
  });
}

} // namespace
