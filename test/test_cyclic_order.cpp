// Cyclic orders against all permutations.
#include "oracle_random.h"

#include "graph/faces/cyclic_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace {

using oracle::Random;
using pcl::manifold::CyclicOrder;
using pcl::manifold::FollowWeight;
using pcl::manifold::joinHeaviestFirst;

using Order = std::vector<std::uint32_t>;

std::int64_t
weightOf (const Order& order, const CyclicOrder& weights)
{
  std::int64_t weight = 0;
  for (std::size_t i = 0; i < order.size (); ++i)
    weight += weights.weight (order[i], order[(i + 1) % order.size ()]);
  return weight;
}

bool
isPermutation (Order order, std::size_t size)
{
  std::sort (order.begin (), order.end ());
  Order all (size);
  std::iota (all.begin (), all.end (), 0u);
  return order == all;
}

std::int64_t
heaviestOfAll (const CyclicOrder& weights)
{
  Order order (weights.size ());
  std::iota (order.begin (), order.end (), 0u);
  std::int64_t best = 0;
  do
    best = std::max (best, weightOf (order, weights));
  while (std::next_permutation (order.begin () + 1, order.end ()));
  return best;
}

TEST (CyclicOrder, IsTheHeaviest)
{
  CyclicOrder cyclic;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    Random random (seed);
    const auto size = static_cast<std::uint32_t> (random.integer (4, 8));
    cyclic.reset (size);
    // Many weights are zero or alike, as between tiles.
    const int largest = random.coin () ? 2 : 1000;
    for (std::uint32_t a = 0; a < size; ++a)
      for (std::uint32_t b = 0; b < a; ++b)
        cyclic.set (a, b, random.coin () ? 0 : random.index (largest));
    const Order order = cyclic.find ();
    EXPECT_TRUE (isPermutation (order, size)) << seed;
    EXPECT_EQ (weightOf (order, cyclic), heaviestOfAll (cyclic)) << seed;
  }
}

TEST (CyclicOrder, OfFewThingsIsAny)
{
  CyclicOrder cyclic;
  for (std::uint32_t size = 0; size <= 3; ++size) {
    cyclic.reset (size);
    EXPECT_TRUE (isPermutation (cyclic.find (), size));
  }
}

// Around a disc those that follow each other are heavy, however much noise there is in between.
TEST (CyclicOrder, IsFoundAroundDiscs)
{
  CyclicOrder cyclic;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    Random random (seed);
    const auto size = static_cast<std::uint32_t> (random.integer (4, CyclicOrder::MOST_THINGS));
    Order around (size);
    std::iota (around.begin (), around.end (), 0u);
    for (std::uint32_t i = size; i-- > 1;)
      std::swap (around[i], around[static_cast<std::size_t> (random.index (static_cast<int> (i) + 1))]);
    cyclic.reset (size);
    for (std::uint32_t i = 0; i < size; ++i)
      for (std::uint32_t j = 0; j < i; ++j) {
        const bool follow = i - j == 1 || i - j == size - 1;
        cyclic.set (around[i], around[j], follow ? random.integer (50, 99) : random.index (45));
      }
    EXPECT_EQ (weightOf (cyclic.find (), cyclic), weightOf (around, cyclic)) << seed;
  }
}

TEST (CyclicOrder, TakesNoTimeOnWeightsWithoutSense)
{
  CyclicOrder cyclic;
  cyclic.reset (CyclicOrder::MOST_THINGS);
  EXPECT_TRUE (isPermutation (cyclic.find (), CyclicOrder::MOST_THINGS));
  Random random (1);
  for (std::uint32_t a = 0; a < CyclicOrder::MOST_THINGS; ++a)
    for (std::uint32_t b = 0; b < a; ++b)
      cyclic.set (a, b, 1000 + random.index (3));
  EXPECT_TRUE (isPermutation (cyclic.find (), CyclicOrder::MOST_THINGS));
}

TEST (HeavyOrder, JoinsPairsByDescendingWeight)
{
  EXPECT_TRUE (joinHeaviestFirst (0, {}).empty ());
  EXPECT_EQ (joinHeaviestFirst (4, {}), Order ({0, 1, 2, 3}));
  // 1 has two neighbours before its third and lightest pair comes; 0 and 3 would close a cycle.
  const std::vector<FollowWeight> weights{{0, 1, 9}, {1, 2, 8}, {1, 4, 1}, {2, 3, 7}, {0, 3, 6}};
  EXPECT_EQ (joinHeaviestFirst (5, weights), Order ({0, 1, 2, 3, 4}));
}

TEST (HeavyOrder, TakesAllThings)
{
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Random random (seed);
    const int size = random.integer (2, 300);
    std::vector<FollowWeight> weights;
    for (int a = 0; a < size; ++a)
      for (int b = a + 1; b < size; b += random.integer (1, 20))
        weights.push_back (
          {static_cast<std::uint32_t> (a), static_cast<std::uint32_t> (b), random.index (9)});
    EXPECT_TRUE (isPermutation (joinHeaviestFirst (static_cast<std::size_t> (size), weights),
                                static_cast<std::size_t> (size)))
      << seed;
  }
}

} // namespace
