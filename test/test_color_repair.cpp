// Whatever the colours, after the repair the surface where they change is a closed manifold.
#include "oracle_surface.h"

#include "extraction/cell_star.h"
#include "extraction/color_repair.h"
#include "extraction/surface_opening.h"
#include "fixed_point/facet_flags.h"

#include <gtest/gtest.h>

#include <set>

namespace {

using namespace oracle;
using pcl::manifold::CellStar;
using pcl::manifold::closedSurface;
using pcl::manifold::DelaunayComplex;
using pcl::manifold::Facet;
using pcl::manifold::FacetFlags;
using pcl::manifold::FacetSet;
using pcl::manifold::insertSamples;
using pcl::manifold::noFacets;
using pcl::manifold::openSurface;
using pcl::manifold::repairColors;
using pcl::manifold::Role;
using pcl::manifold::setFacet;
using pcl::manifold::SurfaceCandidates;
using pcl::manifold::SurfaceTopology;

void
expectClosedManifold (const DelaunayComplex& complex, const std::vector<std::uint8_t>& colors)
{
  for (std::size_t cell = static_cast<std::size_t> (complex.finite_cells); cell < colors.size (); ++cell)
    ASSERT_EQ (colors[cell], 0) << "the outside";
  const SurfaceTopology topology = topologyOf (closedSurface (complex, colors));
  ASSERT_EQ (topology.boundary_edges, 0u);
  ASSERT_EQ (topology.non_manifold_edges, 0u);
  ASSERT_EQ (topology.non_manifold_vertices, 0u);
  ASSERT_TRUE (topology.isManifold ());
}

TEST (ColorRepair, MakesAManifoldOfRandomColors)
{
  int before = 0;
  std::size_t triangles = 0;
  forEachLattice (120, 4, 60, [&] (const Eigen::Matrix3Xd& cloud, int kind) {
    const Prepared prepared = prepare (cloud);
    if (prepared.complex->affine_dimension != 3 || testing::Test::HasFatalFailure ())
      return;
    Random random (static_cast<std::uint64_t> (cloud.cols ()));
    for (int round = 0; round < 4; ++round) {
      SCOPED_TRACE (testing::Message () << "kind " << kind << ", round " << round << "\n" << cloud);
      std::vector<std::uint8_t> colors = randomColors (*prepared.complex, random);
      before += topologyOf (closedSurface (*prepared.complex, colors)).isManifold () ? 0 : 1;
      repairColors ({prepared.dimensions, prepared.roles}, true, colors);
      expectClosedManifold (*prepared.complex, colors);
      insertSamples (prepared.dimensions, prepared.roles, colors);
      expectClosedManifold (*prepared.complex, colors);
      triangles += topologyOf (closedSurface (*prepared.complex, colors)).faces;
    }
  });
  EXPECT_GT (before, 1000);
  EXPECT_GT (triangles, 10000u);
}

// Where only some triangles are candidates the surface may end anywhere, but it has the cells of one colour
// on one side and those of the other colour on the other.
TEST (ColorRepair, MakesTwoSidedSheetsOfRandomColors)
{
  std::size_t triangles = 0;
  forEachLattice (60, 4, 60, [&] (const Eigen::Matrix3Xd& cloud, int kind) {
    const Prepared prepared = prepare (cloud);
    if (prepared.complex->affine_dimension != 3)
      return;
    Random random (static_cast<std::uint64_t> (cloud.cols ()));
    const std::vector<Role> roles (static_cast<std::size_t> (cloud.cols ()), Role::SURFACE);
    for (int round = 0; round < 4; ++round) {
      std::vector<std::uint8_t> colors (prepared.complex->cells.size ());
      for (std::uint8_t& color : colors)
        color = random.coin () ? 1 : 0;
      FacetFlags flags = noFacets (*prepared.complex);
      for (const Facet& facet : finiteFacets (*prepared.complex))
        if (random.index (round + 2) == 0)
          setFacet (*prepared.complex, facet, flags);
      const SurfaceCandidates candidates (prepared.dimensions, roles, &flags);
      repairColors (candidates, false, colors);
      const FacetSet surface = openSurface (candidates, colors);
      std::set<std::pair<std::int32_t, std::int32_t>> directed;
      for (const auto& triangle :
           surface.triangles ([&colors] (std::int32_t cell) { return colors[cell] == 1; })) {
        ++triangles;
        for (std::size_t k = 0; k < 3; ++k)
          ASSERT_TRUE (directed.insert ({triangle[k], triangle[(k + 1) % 3]}).second)
            << "kind " << kind << ", round " << round << "\n"
            << cloud;
      }
    }
  });
  EXPECT_GT (triangles, 1000u);
}

TEST (ColorRepair, LeavesAManifoldAlone)
{
  forEachLattice (20, 4, 40, [&] (const Eigen::Matrix3Xd& cloud, int kind) {
    const Prepared prepared = prepare (cloud);
    if (prepared.complex->affine_dimension != 3)
      return;
    Random random (static_cast<std::uint64_t> (kind));
    std::vector<std::uint8_t> colors = randomColors (*prepared.complex, random);
    repairColors ({prepared.dimensions, prepared.roles}, true, colors);
    const std::vector<std::uint8_t> repaired = colors;
    ASSERT_EQ (repairColors ({prepared.dimensions, prepared.roles}, true, colors), 0u);
    ASSERT_EQ (colors, repaired);
  });
}

// A single cell in the middle of the other colour: its four samples, and a fifth that is then inserted.
TEST (ColorRepair, InsertsASampleByAFlip)
{
  Eigen::Matrix3Xd cloud (3, 5);
  cloud << 0, 12, 0, 0, 3, 0, 0, 12, 0, 3, 0, 0, 0, 12, 2;
  const Prepared prepared = prepare (cloud);
  ASSERT_EQ (prepared.complex->finite_cells, 4);
  // All of the hull but the cell between the fifth sample and one facet of the hull.
  std::vector<Role> roles (5, Role::SURFACE);
  std::vector<std::uint8_t> colors (prepared.complex->cells.size (), 0);
  for (std::size_t cell = 0; cell < 4; ++cell)
    colors[cell] = 1;
  ASSERT_EQ (topologyOf (closedSurface (*prepared.complex, colors)).vertices, 4u);
  EXPECT_EQ (insertSamples (prepared.dimensions, roles, colors), 0u);
  const SurfaceTopology topology = topologyOf (closedSurface (*prepared.complex, colors));
  EXPECT_EQ (topology.vertices, 5u);
  EXPECT_TRUE (topology.isManifold () && topology.isClosed ());
}

TEST (CellStar, SplitsIntoComponentsOfOneColor)
{
  forEachLattice (30, 3, 30, [&] (const Eigen::Matrix3Xd& cloud, int kind) {
    const auto complex = complexOf (cloud);
    if (complex->affine_dimension < 2)
      return;
    Random random (static_cast<std::uint64_t> (kind));
    std::vector<std::uint8_t> colors (complex->cells.size ());
    for (std::uint8_t& color : colors)
      color = random.coin () ? 1 : 0;
    CellStar star (*complex);
    for (std::int32_t sample = 0; sample < cloud.cols (); ++sample) {
      star.split (sample, colors);
      std::multiset<std::set<std::int32_t>> result;
      std::array<std::size_t, 2> fewest{SIZE_MAX, SIZE_MAX}; // of all, and of the finite ones
      for (int component = 0; component < star.components (); ++component) {
        const std::vector<std::int32_t> cells = star.cellsOf (component);
        result.insert (std::set<std::int32_t> (cells.begin (), cells.end ()));
        fewest[0] = std::min (fewest[0], cells.size ());
        if (!complex->isInfinite (cells.back ()))
          fewest[1] = std::min (fewest[1], cells.size ());
      }
      ASSERT_EQ (star.cellsOf (star.smallest (false)).size (), fewest[0]);
      ASSERT_EQ (star.cellsOf (star.smallest (true)).size (), fewest[1] == SIZE_MAX ? fewest[0] : fewest[1]);
      // By flooding over facets at the sample.
      std::multiset<std::set<std::int32_t>> expected;
      std::set<std::int32_t> left (complex->incident_cells.begin () + complex->incident_offsets[sample],
                                   complex->incident_cells.begin () + complex->incident_offsets[sample + 1]);
      while (!left.empty ()) {
        std::set<std::int32_t> component;
        std::vector<std::int32_t> front{*left.begin ()};
        while (!front.empty ()) {
          const std::int32_t cell = front.back ();
          front.pop_back ();
          if (left.erase (cell) == 0)
            continue;
          component.insert (cell);
          for (int k = 0; k < 4; ++k) {
            const std::int32_t neighbor = complex->neighbors[static_cast<std::size_t> (cell)][k];
            if (complex->cells[static_cast<std::size_t> (cell)][k] != sample &&
                colors[neighbor] == colors[cell])
              front.push_back (neighbor);
          }
        }
        expected.insert (component);
      }
      ASSERT_EQ (result, expected) << kind;
    }
  });
}

} // namespace
