#pragma once

#include "oracle_fixed_point.h"

#include "fixed_point/facet_flags.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace oracle {

using pcl::manifold::Facet;
using pcl::manifold::FacetFlags;

/** \brief One flag a triangle, in the order of the oracle. */
using Set = std::vector<std::uint8_t>;

/** \brief The whole restriction DAG by the definition: every triangle against every Voronoi edge. */
struct NaiveDag
{
  RestrictedOracle oracle;
  std::vector<std::vector<std::size_t>> children;

  explicit NaiveDag (const pcl::manifold::DelaunayComplex& complex) : oracle (complex)
  {
    for (const Facet& facet : oracle.facets) {
      children.emplace_back ();
      for (std::size_t i = 0; i < oracle.edges.size (); ++i)
        if (oracle.edges[i].meets (trianglePoints (complex, facet)))
          children.back ().push_back (i);
    }
  }

  std::size_t size () const { return oracle.facets.size (); }

  bool isAnchored (std::size_t i) const
  {
    return std::find (children[i].begin (), children[i].end (), i) != children[i].end ();
  }

  Set apply (const Set& set) const
  {
    Set result (size (), 0);
    for (std::size_t i = 0; i < size (); ++i)
      for (std::size_t k = 0; set[i] != 0 && k < children[i].size (); ++k)
        result[children[i][k]] = 1;
    return result;
  }

  /** \brief A set with all that descends from it. */
  Set closure (Set set) const
  {
    for (Set next;; set = next) {
      next = apply (set);
      for (std::size_t i = 0; i < size (); ++i)
        next[i] |= set[i];
      if (next == set)
        return set;
    }
  }

  Set anchoredOf (Set set) const
  {
    for (std::size_t i = 0; i < size (); ++i)
      set[i] = set[i] != 0 && isAnchored (i) ? 1 : 0;
    return set;
  }

  FacetFlags flagsOf (const pcl::manifold::DelaunayComplex& complex, const Set& set) const
  {
    FacetFlags flags = pcl::manifold::noFacets (complex);
    for (std::size_t i = 0; i < size (); ++i)
      if (set[i] != 0)
        setFacet (complex, oracle.facets[i], flags);
    return flags;
  }

  Set anySet (Random& random) const
  {
    Set set (size ());
    const int share = 1 + random.index (10);
    for (std::uint8_t& flag : set)
      flag = random.index (share) == 0 ? 1 : 0;
    return set;
  }
};

/** \brief Calls body (complex, dag, random) for thousands of small clouds. */
template <typename Body>
void
forEachDag (int rounds, const Body& body)
{
  forEachLattice (rounds, 1, 13, [&body] (const Eigen::Matrix3Xd& cloud, int kind) {
    if (testing::Test::HasFatalFailure ())
      return;
    SCOPED_TRACE (testing::Message () << "kind " << kind << ":\n" << cloud);
    const auto complex = complexOf (cloud);
    Random random (static_cast<std::uint64_t> (kind + 100 * cloud.cols ()));
    body (*complex, NaiveDag (*complex), random);
  });
}

} // namespace oracle
