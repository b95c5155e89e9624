// Whatever triangles are offered to a surface, or are in it: what comes out is a manifold.
#include "oracle_surface.h"

#include "extraction/color_repair.h"
#include "extraction/facet_fitting.h"
#include "extraction/surface_growth.h"
#include "extraction/surface_opening.h"
#include "extraction/surface_pruning.h"

#include <gtest/gtest.h>

#include <set>

namespace {

using namespace oracle;
using pcl::manifold::boundaryLoops;
using pcl::manifold::DelaunayComplex;
using pcl::manifold::eraseToManifold;
using pcl::manifold::Facet;
using pcl::manifold::FacetSet;
using pcl::manifold::fillSmallLoops;
using pcl::manifold::growSurface;
using pcl::manifold::insertFitting;
using pcl::manifold::openSurface;
using pcl::manifold::SurfaceTopology;

std::vector<Facet>
randomFacets (const DelaunayComplex& complex, Random& random)
{
  std::vector<Facet> chosen;
  const double share = random.uniform ();
  for (const Facet& facet : finiteFacets (complex))
    if (random.uniform () < share)
      chosen.push_back (facet);
  for (std::size_t i = chosen.size (); i > 1; --i)
    std::swap (chosen[i - 1], chosen[static_cast<std::size_t> (random.index (static_cast<int> (i)))]);
  return chosen;
}

std::vector<std::int32_t>
allSamples (const DelaunayComplex& complex)
{
  std::vector<std::int32_t> samples;
  for (std::int32_t sample = 0; sample < complex.samples->size (); ++sample)
    samples.push_back (sample);
  return samples;
}

bool
isSubset (const FacetSet& part, const FacetSet& whole)
{
  for (const Facet& facet : finiteFacets (whole.complex ()))
    if (part.contains (facet.cell, facet.facet) && !whole.contains (facet.cell, facet.facet))
      return false;
  return true;
}

// A surface that is a manifold, from random triangles.
FacetSet
randomManifold (const DelaunayComplex& complex, Random& random)
{
  FacetSet surface (complex);
  for (const Facet& facet : randomFacets (complex, random))
    if (random.coin ())
      surface.insert (facet.cell, facet.facet);
  eraseToManifold (allSamples (complex), surface);
  return surface;
}

// body (prepared, random) for clouds with triangles of every kind.
template <typename Body>
void
forEachPrepared (int rounds, const Body& body)
{
  forEachLattice (rounds, 3, 45, [&body] (const Eigen::Matrix3Xd& cloud, int kind) {
    const Prepared prepared = prepare (cloud);
    if (prepared.complex->affine_dimension < 2 || testing::Test::HasFatalFailure ())
      return;
    Random random (static_cast<std::uint64_t> (cloud.cols ()));
    SCOPED_TRACE (testing::Message () << "kind " << kind << ", " << cloud.cols () << " points");
    body (prepared, random);
  });
}

TEST (SurfacePruning, LeavesAManifold)
{
  forEachPrepared (60, [] (const Prepared& prepared, Random& random) {
    FacetSet before (*prepared.complex);
    for (const Facet& facet : randomFacets (*prepared.complex, random))
      before.insert (facet.cell, facet.facet);
    FacetSet after = before;
    eraseToManifold (allSamples (*prepared.complex), after);
    const SurfaceTopology topology = topologyOf (after);
    ASSERT_TRUE (topology.isManifold ());
    ASSERT_TRUE (isSubset (after, before));
    ASSERT_EQ (topology.faces > 0, topologyOf (before).faces > 0) << "the largest fan is kept";
    FacetSet again = after;
    eraseToManifold (allSamples (*prepared.complex), again);
    ASSERT_TRUE (isSubset (after, again)) << "a manifold is left alone";
  });
}

TEST (FacetFitting, KeepsTheManifold)
{
  std::size_t inserted = 0;
  forEachPrepared (60, [&inserted] (const Prepared& prepared, Random& random) {
    FacetSet surface =
      random.coin () ? FacetSet (*prepared.complex) : randomManifold (*prepared.complex, random);
    std::vector<Facet> candidates = randomFacets (*prepared.complex, random);
    FacetSet other_order = surface;
    const std::size_t before = topologyOf (surface).faces;
    insertFitting (candidates, surface);
    const SurfaceTopology topology = topologyOf (surface);
    ASSERT_TRUE (topology.isManifold ());
    if (topology.faces > before)
      inserted += topology.faces - before;
    // The order in which they are offered does not matter, nor that some are offered twice.
    std::reverse (candidates.begin (), candidates.end ());
    candidates.insert (candidates.end (), candidates.begin (), candidates.begin () + candidates.size () / 2);
    insertFitting (candidates, other_order);
    ASSERT_TRUE (isSubset (surface, other_order) && isSubset (other_order, surface));
  });
  EXPECT_GT (inserted, 5000u);
}

TEST (SurfaceGrowth, KeepsTheManifold)
{
  forEachPrepared (60, [] (const Prepared& prepared, Random& random) {
    FacetSet surface = randomManifold (*prepared.complex, random);
    growSurface ({prepared.dimensions, prepared.roles}, surface);
    ASSERT_TRUE (topologyOf (surface).isManifold ());
    const SurfaceTopology before = topologyOf (surface);
    fillSmallLoops (prepared.roles, surface);
    const SurfaceTopology after = topologyOf (surface);
    ASSERT_TRUE (after.isManifold ());
    ASSERT_LE (after.boundary_edges, before.boundary_edges);
  });
}

TEST (SurfaceGrowth, FindsTheBoundaryLoops)
{
  std::size_t count = 0;
  forEachPrepared (60, [&count] (const Prepared& prepared, Random& random) {
    const FacetSet surface = randomManifold (*prepared.complex, random);
    std::map<std::set<std::int32_t>, int> triangles_at;
    for (const auto& triangle : surface.triangles ([] (std::int32_t) { return false; }))
      for (std::size_t k = 0; k < 3; ++k)
        ++triangles_at[{triangle[k], triangle[(k + 1) % 3]}];
    const SurfaceTopology topology = topologyOf (surface);
    const std::vector<std::vector<std::int32_t>> loops = boundaryLoops (surface);
    ASSERT_EQ (loops.size (), topology.boundary_loops);
    std::size_t edges = 0;
    for (const std::vector<std::int32_t>& loop : loops)
      for (std::size_t i = 0; i < loop.size (); ++i, ++edges)
        ASSERT_EQ ((triangles_at[{loop[i], loop[(i + 1) % loop.size ()]}]), 1);
    ASSERT_EQ (edges, topology.boundary_edges);
    count += loops.size ();
  });
  EXPECT_GT (count, 1000u);
}

TEST (SurfaceOpening, GivesAManifoldOfRepairedColors)
{
  forEachPrepared (60, [] (const Prepared& prepared, Random& random) {
    std::vector<std::uint8_t> colors = randomColors (*prepared.complex, random);
    if (random.coin ()) // nor need the outside be one
      for (std::uint8_t& color : colors)
        color ^= random.index (8) == 0 ? 1 : 0;
    pcl::manifold::repairColors ({prepared.dimensions, prepared.roles}, false, colors);
    const FacetSet surface = openSurface ({prepared.dimensions, prepared.roles}, colors);
    ASSERT_TRUE (topologyOf (surface).isManifold ());
    for (const Facet& facet : finiteFacets (*prepared.complex))
      ASSERT_TRUE (!surface.contains (facet.cell, facet.facet) ||
                   colors[static_cast<std::size_t> (facet.cell)] !=
                     colors[static_cast<std::size_t> (
                       prepared.complex->neighbors[static_cast<std::size_t> (facet.cell)][facet.facet])]);
  });
}

} // namespace
