// The candidates of COCONESHAPE, sample by sample and simplex by simplex.
#include "oracle_surface.h"

#include "extraction/candidates.h"
#include "extraction/surface_candidates.h"
#include "voronoi/cocone.h"

#include <gtest/gtest.h>

#include <set>

namespace {

using namespace oracle;
using pcl::SimplicialComplex;
using pcl::manifold::coconeMeetsEdge;
using pcl::manifold::coconeNeighbors;
using pcl::manifold::collectCandidates;
using pcl::manifold::DelaunayComplex;
using pcl::manifold::Facet;
using pcl::manifold::Role;
using pcl::manifold::VoronoiCell;
using Simplex = std::set<std::int32_t>;

bool
meetsDualEdge (const Prepared& prepared, std::int32_t sample, const Facet& facet)
{
  return coconeMeetsEdge (
    VoronoiCell (*prepared.complex, sample), prepared.dimensions.normals.col (sample), facet.cell,
    prepared.complex
      ->neighbors[static_cast<std::size_t> (facet.cell)][static_cast<std::size_t> (facet.facet)]);
}

// The k-simplices at samples of dimension k dual to what their cocones meet.
std::set<Simplex>
expectedCandidates (const Prepared& prepared)
{
  const DelaunayComplex& complex = *prepared.complex;
  const std::vector<std::uint8_t>& dimension = prepared.dimensions.dimension;
  std::set<Simplex> expected;
  for (std::int32_t p = 0; p < complex.samples->size (); ++p)
    if (dimension[static_cast<std::size_t> (p)] == 1)
      for (const std::int32_t q :
           coconeNeighbors (complex, VoronoiCell (complex, p), prepared.dimensions.tangents.col (p)))
        expected.insert ({p, q});
  for (const Facet& facet : finiteFacets (complex)) {
    const std::array<std::int32_t, 3> triangle = facetOf (complex, facet.cell, facet.facet);
    for (const std::int32_t p : triangle)
      if (dimension[static_cast<std::size_t> (p)] == 2 && meetsDualEdge (prepared, p, facet))
        expected.insert (Simplex (triangle.begin (), triangle.end ()));
  }
  for (std::int32_t i = 0; i < complex.finite_cells; ++i) {
    const DelaunayComplex::Cell& cell = complex.cells[static_cast<std::size_t> (i)];
    for (const std::int32_t p : cell)
      if (dimension[static_cast<std::size_t> (p)] == 3)
        expected.insert (Simplex (cell.begin (), cell.end ()));
  }
  return expected;
}

template <typename Cells>
void
addSimplices (const Cells& cells, std::multiset<Simplex>& simplices)
{
  for (const auto& cell : cells) {
    EXPECT_TRUE (std::is_sorted (cell.begin (), cell.end ()));
    simplices.insert (Simplex (cell.begin (), cell.end ()));
  }
}

TEST (Candidates, AreThoseOfTheDefinition)
{
  forEachLattice (40, 3, 40, [] (const Eigen::Matrix3Xd& cloud, int kind) {
    const Prepared prepared = prepare (cloud);
    if (prepared.complex->affine_dimension < 2)
      return;
    const SimplicialComplex candidates = collectCandidates (prepared.dimensions);
    std::multiset<Simplex> result;
    addSimplices (candidates.edges, result);
    addSimplices (candidates.triangles, result);
    addSimplices (candidates.tetrahedra, result);
    const std::set<Simplex> expected = expectedCandidates (prepared);
    ASSERT_EQ (result, std::multiset<Simplex> (expected.begin (), expected.end ())) << kind;
  });
}

TEST (Candidates, OfTheExtractionAreThoseOfSurfaceSamples)
{
  forEachLattice (30, 3, 40, [] (const Eigen::Matrix3Xd& cloud, int kind) {
    const Prepared prepared = prepare (cloud);
    for (const Facet& facet : finiteFacets (*prepared.complex)) {
      bool expected = false;
      for (const std::int32_t p : facetOf (*prepared.complex, facet.cell, facet.facet))
        expected = expected || (prepared.roles[static_cast<std::size_t> (p)] == Role::SURFACE &&
                                meetsDualEdge (prepared, p, facet));
      ASSERT_EQ (pcl::manifold::SurfaceCandidates (prepared.dimensions, prepared.roles)
                   .contains (facet.cell, facet.facet),
                 expected)
        << kind;
    }
  });
}

TEST (Candidates, OfALineAreItsPieces)
{
  Eigen::Matrix3Xd cloud (3, 4);
  cloud << 3, 0, 10, 1, 6, 0, 20, 2, 0, 0, 0, 0;
  const SimplicialComplex candidates = collectCandidates (prepare (cloud).dimensions);
  EXPECT_EQ (candidates.edges, (std::vector<SimplicialComplex::Edge>{{0, 2}, {0, 3}, {1, 3}}));
  EXPECT_TRUE (candidates.triangles.empty () && candidates.tetrahedra.empty ());
}

} // namespace
