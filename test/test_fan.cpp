// The link of a vertex against its definition as a graph.
#include "oracle_random.h"

#include "extraction/fan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

namespace {

using oracle::Random;
using pcl::manifold::Fan;
using Side = std::pair<std::int32_t, std::int32_t>;

// Components of a graph by flooding, each with the degrees of its vertices.
struct Graph
{
  explicit Graph (const std::vector<Side>& sides) : component (sides.size (), -1)
  {
    for (const Side& side : sides) {
      ++degree[side.first];
      ++degree[side.second];
    }
    for (std::size_t seed = 0; seed < sides.size (); ++seed) {
      if (component[seed] >= 0)
        continue;
      std::set<std::int32_t> reached{sides[seed].first};
      for (bool grows = true; grows;) {
        grows = false;
        for (std::size_t i = 0; i < sides.size (); ++i)
          if (component[i] < 0 && (reached.count (sides[i].first) + reached.count (sides[i].second)) > 0) {
            component[i] = components;
            reached.insert ({sides[i].first, sides[i].second});
            grows = true;
          }
      }
      ++components;
      vertices.push_back (reached);
    }
  }

  bool isPath (std::size_t c) const { return isLine (c) && countEnds (c) == 2; }
  bool isCycle (std::size_t c) const { return isLine (c) && countEnds (c) == 0; }

  int components = 0;
  std::vector<int> component;
  std::map<std::int32_t, int> degree;
  std::vector<std::set<std::int32_t>> vertices;

private:
  bool isLine (std::size_t c) const
  {
    return std::all_of (vertices[c].begin (), vertices[c].end (),
                        [this] (int v) { return degree.at (v) <= 2; });
  }

  long countEnds (std::size_t c) const
  {
    return std::count_if (vertices[c].begin (), vertices[c].end (),
                          [this] (int v) { return degree.at (v) == 1; });
  }
};

// Mostly paths and cycles, with a few changes.
std::vector<Side>
randomSides (Random& random)
{
  std::set<Side> sides;
  const auto add = [&sides] (int a, int b) {
    if (a != b)
      sides.insert ({std::min (a, b), std::max (a, b)});
  };
  int next = -1; // the infinite vertex may be among them
  for (int part = random.index (4); part > 0; --part) {
    const int length = random.integer (1, 5);
    for (int i = 0; i < length; ++i)
      add (next + i, next + i + 1);
    if (length > 1 && random.coin ())
      add (next, next + length);
    next += length + 1;
  }
  if (next > 0)
    for (int change = random.index (3); change > 0; --change)
      add (random.index (next), random.index (next));
  std::vector<Side> result (sides.begin (), sides.end ());
  for (std::size_t i = result.size (); i > 1; --i)
    std::swap (result[i - 1], result[static_cast<std::size_t> (random.index (static_cast<int> (i)))]);
  for (Side& side : result)
    if (random.coin ())
      std::swap (side.first, side.second);
  return result;
}

TEST (Fan, IsThatOfTheDefinition)
{
  std::map<int, int> seen;
  for (std::uint64_t seed = 0; seed < 20000; ++seed) {
    Random random (seed);
    const std::vector<Side> sides = randomSides (random);
    Fan fan;
    for (const Side& side : sides)
      fan.add (side.first, side.second);
    const Graph graph (sides);
    ASSERT_EQ (fan.size (), sides.size ());

    int components = -1;
    ASSERT_EQ (fan.split (components), graph.component);
    ASSERT_EQ (components, graph.components);
    for (std::int32_t v = -1; v < 30; ++v)
      ASSERT_EQ (fan.degree (v), graph.degree.count (v) != 0 ? graph.degree.at (v) : 0);

    bool paths = true;
    for (std::size_t c = 0; c < graph.vertices.size (); ++c)
      paths = paths && graph.isPath (c);
    const bool one_path = graph.components == 1 && paths;
    const bool one_cycle = graph.components == 1 && graph.isCycle (0);
    ASSERT_EQ (fan.isManifold (), sides.empty () || one_path || one_cycle);
    ASSERT_EQ (fan.canBecomeManifold (), paths || one_cycle);
    ASSERT_EQ (fan.isClosed (), one_cycle);
    std::set<std::int32_t> first;
    std::set<std::int32_t> second;
    for (const Side& side : sides) {
      first.insert (side.first);
      second.insert (side.second);
    }
    const bool directed = first.size () == sides.size () && second.size () == sides.size ();
    ASSERT_EQ (fan.isDirected (), directed);
    ++seen[one_path || one_cycle ? (directed ? 5 : 6) : 4];
    ++seen[one_path ? 1 : (one_cycle ? 2 : (paths ? 3 : 4))];

    std::set<std::int32_t> ends;
    if (one_path)
      for (const auto& entry : graph.degree)
        if (entry.second == 1)
          ends.insert (entry.first);
    const std::array<std::int32_t, 2> result = fan.ends ();
    if (one_path)
      ASSERT_EQ (std::set<std::int32_t> (result.begin (), result.end ()), ends);
    else
      ASSERT_EQ (result, (std::array<std::int32_t, 2>{-1, -1}));
  }
  for (int kind = 1; kind <= 6; ++kind)
    EXPECT_GT (seen[kind], 1000) << kind;
}

} // namespace
