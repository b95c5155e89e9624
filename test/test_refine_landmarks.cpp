// The added landmarks against their definition, by the hops between all pairs of vertices.
#include "oracle_graph_kinds.h"

#include "graph/landmarks/hop_rings.h"
#include "graph/landmarks/priority.h"
#include "graph/landmarks/tile_rings.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace {

using namespace oracle;
using pcl::manifold::AdjacencyRule;
using pcl::manifold::ContactRows;
using pcl::manifold::findDoubtfulTiles;
using pcl::manifold::graphVoronoiDiagram;
using pcl::manifold::HopRings;
using pcl::manifold::maximalStableSet;
using pcl::manifold::priorityOf;
using pcl::manifold::refineLandmarks;
using pcl::manifold::tileContacts;

using Vertices = std::vector<index_t>;

/** The sizes of the parts of some vertices that hang together by edges among themselves. */
std::vector<std::size_t>
partsOf (const NeighborhoodGraph& graph, const Vertices& vertices)
{
  std::vector<std::size_t> sizes;
  std::set<index_t> left (vertices.begin (), vertices.end ());
  while (!left.empty ()) {
    Vertices part{*left.begin ()};
    left.erase (left.begin ());
    for (std::size_t i = 0; i < part.size (); ++i)
      for (const index_t* w = graph.begin (part[i]); w != graph.end (part[i]); ++w)
        if (left.erase (*w) > 0)
          part.push_back (*w);
    sizes.push_back (part.size ());
  }
  return sizes;
}

/** By the definition: bands of two rings, counted from the largest radius inwards. */
int
radiusByHops (const NeighborhoodGraph& graph, const std::vector<int>& hops, int least, int most)
{
  const int farthest = *std::max_element (hops.begin (), hops.end (), [] (int a, int b) {
    return (a == UNREACHABLE ? -1 : a) < (b == UNREACHABLE ? -1 : b);
  });
  int radius = 0;
  for (int outer = most % 2 == 0 ? 2 : 1; outer <= most; outer += 2) {
    if (outer > farthest)
      break;
    Vertices band;
    for (index_t v = 0; v < graph.size (); ++v)
      if (hops[static_cast<std::size_t> (v)] > 0 && hops[static_cast<std::size_t> (v)] <= outer &&
          hops[static_cast<std::size_t> (v)] > outer - 2)
        band.push_back (v);
    std::size_t large = 0;
    for (const std::size_t size : partsOf (graph, band))
      large += size >= 3 && 4 * size >= band.size () ? 1 : 0;
    if (outer > least && large > 1)
      break;
    radius = outer;
  }
  return radius;
}

TEST (HopRings, FindTheLargestDisk)
{
  forEachGraph (60, 130, [&] (const NeighborhoodGraph& graph, const std::string& name) {
    SCOPED_TRACE (name);
    const Hops hops = hopsBetweenAll (graph);
    HopRings rings (graph);
    for (const int least : {0, 2, 4})
      for (const int most : {1, 2, 5, 7, 8, 40})
        for (index_t v = 0; v < graph.size (); v += 3)
          ASSERT_EQ (rings.radiusOfDisk (v, least, most),
                     radiusByHops (graph, hops[static_cast<std::size_t> (v)], least, most))
            << "vertex " << v << ", " << least << " to " << most;
  });
}

TEST (DoubtfulTiles, HaveNeighboursThatDoNotHangTogether)
{
  std::uint64_t seed = 0;
  forEachGraph (60, 130, [&] (const NeighborhoodGraph& graph, const std::string& name) {
    SCOPED_TRACE (name);
    for (const int k : {1, 2, 3}) {
      const Vertices landmarks = maximalStableSet (graph, k, ++seed, 1);
      const Vertices tiles = graphVoronoiDiagram (graph, landmarks, 1);
      const auto contacts = tileContacts (graph, landmarks, tiles, AdjacencyRule::BOUNDARY_POINTS, 0, 1);
      const std::vector<std::uint8_t> doubtful =
        findDoubtfulTiles (ContactRows (landmarks.size (), contacts));
      EdgeSet touching;
      for (const TileContact& contact : contacts)
        touching.emplace (contact.first, contact.second);
      const NeighborhoodGraph of_tiles = graphOfEdges (static_cast<int> (landmarks.size ()), touching);
      const Hops steps = hopsBetweenAll (of_tiles);
      ASSERT_EQ (doubtful.size (), landmarks.size ());
      for (std::size_t tile = 0; tile < landmarks.size (); ++tile) {
        bool expected = false;
        for (const int step : {1, 2}) {
          Vertices ring;
          for (index_t other = 0; other < of_tiles.size (); ++other)
            if (steps[tile][static_cast<std::size_t> (other)] == step)
              ring.push_back (other);
          expected = expected || partsOf (of_tiles, ring).size () != 1;
        }
        ASSERT_EQ (doubtful[tile] != 0, expected) << "tile " << tile;
      }
    }
  });
}

/** The definition of refineLandmarks, step by step. */
Vertices
refineByHops (const NeighborhoodGraph& graph, const Hops& hops, int k, std::uint64_t seed,
              const Vertices& landmarks, const std::vector<std::uint8_t>& doubtful)
{
  const auto at = [&hops] (index_t v, index_t w) {
    return hops[static_cast<std::size_t> (v)][static_cast<std::size_t> (w)];
  };
  Vertices result = landmarks;
  Vertices fresh;
  for (std::size_t i = 0; i < landmarks.size (); ++i)
    if (doubtful[i] != 0)
      fresh.push_back (landmarks[i]);
  std::vector<int> allowed (hops.size (), k);
  Vertices order (hops.size ());
  std::iota (order.begin (), order.end (), 0);
  std::sort (order.begin (), order.end (), [seed] (index_t v, index_t w) {
    return std::make_pair (priorityOf (v, seed), v) < std::make_pair (priorityOf (w, seed), w);
  });
  while (!fresh.empty ()) {
    for (const index_t landmark : fresh) {
      const int enough = static_cast<int> (std::ceil (1.6 * k - 1e-9));
      const int radius = radiusByHops (graph, hops[static_cast<std::size_t> (landmark)], 4, enough);
      const int wanted = std::max (3, static_cast<int> (std::floor (0.625 * radius + 1e-9)));
      if (wanted < k)
        for (index_t v = 0; v < graph.size (); ++v)
          if (at (v, landmark) <= static_cast<int> (std::ceil (0.6 * k - 1e-9)))
            allowed[static_cast<std::size_t> (v)] = std::min (allowed[static_cast<std::size_t> (v)], wanted);
    }
    fresh.clear ();
    for (const index_t v : order)
      if (allowed[static_cast<std::size_t> (v)] < k &&
          std::all_of (result.begin (), result.end (),
                       [&] (index_t w) { return at (v, w) >= allowed[static_cast<std::size_t> (v)]; })) {
        result.push_back (v);
        fresh.push_back (v);
      }
  }
  std::sort (result.begin (), result.end ());
  return result;
}

TEST (RefineLandmarks, AddsThoseOfTheDefinition)
{
  std::uint64_t seed = 0;
  std::size_t added = 0;
  forEachGraph (80, 130, [&] (const NeighborhoodGraph& graph, const std::string& name) {
    SCOPED_TRACE (name);
    const Hops hops = hopsBetweenAll (graph);
    ++seed;
    for (const int k : {1, 3, 4, 5, 6, 9, 14, 1000}) {
      const Vertices landmarks = maximalStableSet (graph, k, seed, 1);
      const Vertices tiles = graphVoronoiDiagram (graph, landmarks, 1);
      const auto contacts = tileContacts (graph, landmarks, tiles, AdjacencyRule::BOUNDARY_POINTS, 7, 1);
      const Vertices refined = refineLandmarks (graph, k, seed, landmarks, tiles, contacts, {}, 1);
      if (k <= 3) {
        ASSERT_EQ (refined, landmarks);
        continue;
      }
      const int no_more = std::min (k, std::max (graph.size (), 4));
      ASSERT_EQ (refined, refineByHops (graph, hops, no_more, seed, landmarks,
                                        findDoubtfulTiles (ContactRows (landmarks.size (), contacts))))
        << k << " hops";
      ASSERT_TRUE (std::includes (refined.begin (), refined.end (), landmarks.begin (), landmarks.end ()));
      added += refined.size () - landmarks.size ();
      ASSERT_EQ (refined, refineLandmarks (graph, k, seed, landmarks, tiles, contacts, {}, 2));
    }
  });
  EXPECT_GT (added, 1000U);
}

/** Points on a grid around a tube, about a unit apart, as a graph. */
NeighborhoodGraph
tube (int around, int along)
{
  Eigen::MatrixXd points (3, around * along);
  const double radius = around / (2.0 * M_PI);
  for (int i = 0; i < around * along; ++i) {
    const double angle = 2.0 * M_PI * (i % around + 0.5 * (i / around % 2)) / around;
    points.col (i) << radius * std::cos (angle), radius * std::sin (angle), 0.87 * (i / around);
  }
  NeighborhoodGraph graph;
  pcl::manifold::nearestNeighborGraph (points, 15, 1, graph);
  return graph;
}

std::size_t
countAdded (const NeighborhoodGraph& graph, int k)
{
  const Vertices landmarks = maximalStableSet (graph, k, 1, 1);
  const Vertices tiles = graphVoronoiDiagram (graph, landmarks, 1);
  const auto contacts = tileContacts (graph, landmarks, tiles, AdjacencyRule::BOUNDARY_POINTS, 7, 1);
  return refineLandmarks (graph, k, 1, landmarks, tiles, contacts, {}, 1).size () - landmarks.size ();
}

TEST (RefineLandmarks, AddsThemAroundThinTubesOnly)
{
  EXPECT_GT (countAdded (tube (18, 200), 5), 50U);
  // A hop goes over two points or so: a wide tube has disks of eight hops everywhere but at its ends.
  EXPECT_EQ (countAdded (tube (120, 80), 5), 0U);
  // Gaps of random points may look like the hole of a handle.
  EXPECT_LT (countAdded (largeGraph (), 5), 20U);
}

} // namespace
