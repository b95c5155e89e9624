// Disjoint sets with two colours against a list of sets, and the spanning forest against Kruskal's algorithm.
#include "oracle_random.h"

#include "common/parity_forest.h"
#include "extraction/spanning_forest.h"

#include <gtest/gtest.h>

namespace {

using oracle::Random;
using pcl::manifold::ParityForest;

// Every element with the number of its set and its colour.
class Listed
{
public:
  explicit Listed (int n) : set_ (static_cast<std::size_t> (n)), color_ (static_cast<std::size_t> (n), 0)
  {
    for (std::size_t i = 0; i < set_.size (); ++i)
      set_[i] = static_cast<int> (i);
  }

  bool unite (std::size_t a, std::size_t b, bool opposite)
  {
    if (set_[a] == set_[b])
      return false;
    const int flip = color_[a] ^ color_[b] ^ (opposite ? 1 : 0);
    const int old = set_[b];
    for (std::size_t i = 0; i < set_.size (); ++i)
      if (set_[i] == old) {
        set_[i] = set_[a];
        color_[i] ^= flip;
      }
    return true;
  }

  bool together (std::size_t a, std::size_t b) const { return set_[a] == set_[b]; }

  bool differ (std::size_t a, std::size_t b) const { return color_[a] != color_[b]; }

private:
  std::vector<int> set_;
  std::vector<int> color_;
};

TEST (ParityForest, KeepsSetsAndColors)
{
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Random random (seed);
    const int n = random.integer (1, 60);
    ParityForest forest (static_cast<std::size_t> (n));
    Listed listed (n);
    for (int step = 0; step < 2 * n; ++step) {
      const auto a = static_cast<std::uint32_t> (random.index (n));
      const auto b = static_cast<std::uint32_t> (random.index (n));
      const bool opposite = random.coin ();
      ASSERT_EQ (forest.unite (a, b, opposite), listed.unite (a, b, opposite));
      if (random.index (10) == 0)
        forest.compress ();
      const auto c = static_cast<std::uint32_t> (random.index (n));
      const auto looked = forest.look (c);
      ASSERT_EQ (looked, forest.find (c));
      ASSERT_EQ (looked, forest.look (c));
    }
    for (std::uint32_t a = 0; a < static_cast<std::uint32_t> (n); ++a)
      for (std::uint32_t b = 0; b < static_cast<std::uint32_t> (n); ++b) {
        const auto [root_a, parity_a] = forest.find (a);
        const auto [root_b, parity_b] = forest.look (b);
        ASSERT_EQ (root_a == root_b, listed.together (a, b));
        ASSERT_TRUE (root_a != root_b || (parity_a != parity_b) == listed.differ (a, b));
      }
  }
}

// Random wishes with many equal steps, some of which are none.
struct RandomWishes
{
  struct Wish
  {
    std::uint32_t a, b, step;
    bool opposite;
  };
  std::vector<Wish> wishes;

  RandomWishes (Random& random, int elements)
  {
    for (int i = random.integer (0, 3 * elements); i > 0; --i)
      wishes.push_back ({static_cast<std::uint32_t> (random.index (elements)),
                         static_cast<std::uint32_t> (random.index (elements)),
                         static_cast<std::uint32_t> (random.integer (0, 9)), random.coin ()});
  }

  std::uint64_t size () const { return wishes.size (); }

  bool valid (pcl::manifold::Wish wish) const { return wishes[wish].step > 0; }

  std::uint32_t step (pcl::manifold::Wish wish) const { return wishes[wish].step; }

  std::pair<std::uint32_t, std::uint32_t> ends (pcl::manifold::Wish wish) const
  {
    return {wishes[wish].a, wishes[wish].b};
  }

  bool opposite (pcl::manifold::Wish wish) const { return wishes[wish].opposite; }
};

TEST (SpanningForest, HasKeysForWishesBeyond32Bits)
{
  using pcl::manifold::Wish;
  using pcl::manifold::WishKey;
  constexpr Wish CELLS = INT32_MAX;
  constexpr Wish LAST = 4 * CELLS + CELLS - 1; // four facets a cell, and a sample
  static_assert (LAST > UINT32_MAX && LAST < Wish (1) << WishKey::WISH_BITS);
  for (const Wish wish : {Wish (0), Wish (1), Wish (UINT32_MAX), Wish (UINT32_MAX) + 1, LAST})
    for (const std::uint32_t step : {0U, 1U, 4096U}) {
      const std::uint64_t key = WishKey::of (step, wish);
      EXPECT_EQ (WishKey::wishOf (key), wish);
      EXPECT_LT (key, WishKey::of (step, wish + 1));
      EXPECT_LT (WishKey::of (step, LAST), WishKey::of (step + 1, wish));
    }
}

TEST (SpanningForest, GrantsWishesInTheirOrder)
{
  for (std::uint64_t seed = 0; seed < 3000; ++seed) {
    Random random (seed);
    const int n = random.integer (1, 80);
    const RandomWishes wishes (random, n);
    ParityForest forest (static_cast<std::size_t> (n));
    Listed listed (n);
    for (int i = random.integer (0, 4); i > 0; --i) { // what was joined before
      const auto a = static_cast<std::uint32_t> (random.index (n));
      const auto b = static_cast<std::uint32_t> (random.index (n));
      forest.unite (a, b, i % 2 == 0);
      listed.unite (a, b, i % 2 == 0);
    }
    for (std::uint32_t step = 1; step < 10; ++step)
      for (const auto& wish : wishes.wishes)
        if (wish.step == step)
          listed.unite (wish.a, wish.b, wish.opposite);
    const std::size_t few = static_cast<std::size_t> (random.integer (0, 20));
    pcl::manifold::SpanningForest<RandomWishes> (wishes, forest, few).grow ();
    for (std::uint32_t a = 0; a < static_cast<std::uint32_t> (n); ++a)
      for (std::uint32_t b = 0; b < a; ++b) {
        const auto [root_a, parity_a] = forest.look (a);
        const auto [root_b, parity_b] = forest.look (b);
        ASSERT_EQ (root_a == root_b, listed.together (a, b)) << "seed " << seed;
        ASSERT_TRUE (root_a != root_b || (parity_a != parity_b) == listed.differ (a, b)) << "seed " << seed;
      }
  }
}

} // namespace
