// Disjoint sets with two colours against a list of sets.
#include "oracle_random.h"

#include "extraction/parity_forest.h"

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

} // namespace
