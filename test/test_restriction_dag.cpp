// Anchored triangles, the restriction DAG and fixed points against their definitions.
#include "oracle_restriction_dag.h"

#include "fixed_point/anchored.h"
#include "fixed_point/restriction_dag.h"

#include <pcl/manifold/fixed_point_complex.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <vector>

namespace {

using namespace oracle;
using pcl::manifold::anchoredTriangles;
using pcl::manifold::DelaunayComplex;
using pcl::manifold::facetsOf;
using pcl::manifold::FixedPoint;
using pcl::manifold::fixedPoint;
using pcl::manifold::noFacets;
using pcl::manifold::restrictedDelaunay;
using pcl::manifold::restrictionDag;

constexpr int ROUNDS = 80;

TEST (FixedPoint, AnchoredTrianglesMeetTheirOwnVoronoiEdges)
{
  std::size_t anchored = 0;
  forEachDag (ROUNDS, [&] (const DelaunayComplex& complex, const NaiveDag& dag, Random&) {
    std::vector<Facet> expected;
    for (std::size_t i = 0; i < dag.size (); ++i)
      if (dag.isAnchored (i))
        expected.push_back (dag.oracle.facets[i]);
    ASSERT_TRUE (anchoredTriangles (complex) == expected);
    anchored += expected.size ();
  });
  EXPECT_GT (anchored, 5000u);
}

TEST (FixedPoint, IsWhereNaiveRepetitionEnds)
{
  int longest = 0;
  forEachDag (ROUNDS, [&] (const DelaunayComplex& complex, const NaiveDag& dag, Random& random) {
    const Set start = dag.anySet (random);
    Set expected = start;
    int iterations = 0;
    for (Set next = dag.apply (expected); next != expected; next = dag.apply (expected)) {
      expected = next;
      ++iterations;
    }
    const FixedPoint result = fixedPoint (complex, dag.flagsOf (complex, start));
    ASSERT_TRUE (result.facets == dag.flagsOf (complex, expected));
    ASSERT_EQ (result.iterations, iterations);
    ASSERT_TRUE (restrictedDelaunay (complex, result.facets) == result.facets) << "not fixed";
    longest = std::max (longest, iterations);
    // Theorem 2.
    ASSERT_TRUE (dag.closure (dag.anchoredOf (dag.closure (start))) == expected);
  });
  EXPECT_GE (longest, 4);
}

// Lemma 1: a triangle generates such of smaller circumradius only, or of the same circumcentre.
TEST (FixedPoint, CircumradiiNeverGrow)
{
  std::size_t shrunk = 0;
  forEachDag (ROUNDS, [&] (const DelaunayComplex& complex, const NaiveDag& naive, Random& random) {
    std::map<Facet, std::size_t> number;
    for (std::size_t i = 0; i < naive.size (); ++i)
      number[naive.oracle.facets[i]] = i;
    const pcl::manifold::RestrictionDag dag =
      restrictionDag (complex, facetsOf (complex, naive.flagsOf (complex, naive.anySet (random))));
    for (std::size_t i = 0; i < dag.nodes.size (); ++i)
      for (std::size_t k = dag.children.offsets[i]; k < dag.children.offsets[i + 1]; ++k) {
        const auto& parent = naive.oracle.edges[number.at (dag.nodes[i])];
        const auto& child = naive.oracle.edges[number.at (dag.children.facets[k])];
        const auto before = parent.squaredRadius ();
        const auto after = child.squaredRadius ();
        const int growth = sign<WideInteger> (after[0] * before[1] - before[0] * after[1]);
        ASSERT_LE (growth, 0);
        ASSERT_TRUE (growth < 0 || parent.hasSameCenter (child));
        shrunk += growth < 0 ? 1 : 0;
      }
  });
  EXPECT_GT (shrunk, 1000u);
}

TEST (FixedPoint, TheDagHasEveryDescendantOnce)
{
  forEachDag (ROUNDS / 4, [] (const DelaunayComplex& complex, const NaiveDag& naive, Random& random) {
    const Set start = naive.anySet (random);
    const pcl::manifold::RestrictionDag dag =
      restrictionDag (complex, facetsOf (complex, naive.flagsOf (complex, start)));
    ASSERT_TRUE (dag.reached == naive.flagsOf (complex, naive.closure (start)));
    std::vector<Facet> nodes = dag.nodes;
    std::sort (nodes.begin (), nodes.end ());
    ASSERT_TRUE (nodes == facetsOf (complex, dag.reached));
    ASSERT_EQ (dag.children.offsets.size (), nodes.size () + 1);
  });
}

// A clique of anchored triangles stays together: the right-angled ones of a square or of a cube.
TEST (FixedPoint, KeepsCliquesTogether)
{
  for (const int corners : {4, 8}) {
    Eigen::Matrix3Xd cloud (3, corners);
    for (int i = 0; i < corners; ++i)
      cloud.col (i) = Eigen::Vector3d (2 * (i & 1), i & 2, i < 4 ? 0 : 2);
    const auto complex = complexOf (cloud);
    const std::vector<Facet> anchored = anchoredTriangles (*complex);
    std::size_t cliques = 0;
    for (const Facet& facet : anchored) {
      FacetFlags start = noFacets (*complex);
      setFacet (*complex, facet, start);
      const FixedPoint result = fixedPoint (*complex, start);
      EXPECT_TRUE (result.facets.contains (facet.cell, facet.facet));
      const VoronoiEdge<WideInteger> edge (trianglePoints (*complex, facet));
      for (const Facet& other : anchored)
        if (!(other == facet) &&
            edge.hasSameCenter (VoronoiEdge<WideInteger> (trianglePoints (*complex, other)))) {
          EXPECT_TRUE (result.facets.contains (other.cell, other.facet));
          ++cliques;
        }
    }
    EXPECT_GE (cliques, corners == 4 ? 2u : 12u);
  }
}

} // namespace
