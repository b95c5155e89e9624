#pragma once

#include "common/parallel.h"
#include "common/parity_forest.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace manifold {

/** The number of a wish: there may be five of them for every cell. */
using Wish = std::uint64_t;

/** Steps and wishes in one number each, in the order in which they are granted: by their steps, and within a
 * step by their numbers. Wishes are below 2^48, steps below 2^16. */
struct WishKey
{
  static constexpr int WISH_BITS = 48;

  static constexpr std::uint64_t of (std::uint32_t step, Wish wish)
  {
    return static_cast<std::uint64_t> (step) << WISH_BITS | wish;
  }

  static constexpr Wish wishOf (std::uint64_t key) { return key & ((Wish (1) << WISH_BITS) - 1); }
};

/** A maximum spanning forest of a signed graph, into a ParityForest. A wish is a signed edge: it asks for the
 * same colour of its two ends (+) or for opposite ones (-). Wishes are granted one after the other in the
 * order of their keys, as Kruskal's algorithm takes edges: each joins two sets, or comes too late.
 *
 * Which wishes join two sets does not depend on how the forest is found, so it is grown in rounds (Boruvka):
 * every set grants the first wish of its own, in parallel. What little is left is sorted.
 *
 * Wishes must have
 *   std::uint64_t size () const
 *   bool valid (wish) const                  false: there is no such wish
 *   std::uint32_t step (wish) const          the order of wishes; within a step they go by their number
 *   std::pair<uint32, uint32> ends (wish) const
 *   bool opposite (wish) const               are the ends to get opposite colours? */
template <typename Wishes>
class SpanningForest
{
public:
  /** \param[in] few so many wishes are sorted at the end */
  SpanningForest (const Wishes& wishes, ParityForest& forest, std::size_t few = 20000)
    : wishes_ (wishes), forest_ (forest), few_ (few), first_ (forest.size ())
  {
    parallelFor (first_.size (),
                 [this] (std::size_t i) { first_[i].store (NONE, std::memory_order_relaxed); });
  }

  void grow ()
  {
    forest_.compress ();
    parallelFor (wishes_.size (), [this] (std::size_t i) {
      const auto wish = static_cast<Wish> (i);
      if (wishes_.valid (wish)) {
        const auto [a, b] = wishes_.ends (wish);
        look ({wish, a, b});
      }
    });
    std::vector<std::uint32_t> roots =
      gather<std::uint32_t> (forest_.size (), [this] (std::size_t i, const auto& append) {
        const auto element = static_cast<std::uint32_t> (i);
        if (forest_.look (element).first == element)
          append (element);
      });
    grantFirst (roots);
    // Half of the wishes and more join nothing from now on.
    std::vector<Open> open = gather<Open> (wishes_.size (), [this] (std::size_t i, const auto& append) {
      const auto wish = static_cast<Wish> (i);
      if (!wishes_.valid (wish))
        return;
      const auto [a, b] = wishes_.ends (wish);
      const Open now = look ({wish, a, b});
      if (now.a != now.b)
        append (now);
    });
    while (open.size () > few_) {
      grantFirst (roots);
      open = gather<Open> (open.size (), [&] (std::size_t i, const auto& append) {
        const Open now = look (open[i]);
        if (now.a != now.b)
          append (now);
      });
    }
    std::sort (open.begin (), open.end (),
               [this] (const Open& a, const Open& b) { return keyOf (a.wish) < keyOf (b.wish); });
    for (const Open& last : open) {
      const auto [a, b] = wishes_.ends (last.wish);
      forest_.unite (a, b, wishes_.opposite (last.wish));
    }
  }

private:
  // A wish that may still join two sets, and elements of these: their roots, as of the round before.
  struct Open
  {
    Wish wish;
    std::uint32_t a;
    std::uint32_t b;
  };

  static constexpr std::uint64_t NONE = UINT64_MAX;
  static constexpr std::size_t PIECE = 32768;

  std::uint64_t keyOf (Wish wish) const { return WishKey::of (wishes_.step (wish), wish); }

  // What visit (i, append) appends for every i below n, in their order.
  template <typename Item, typename Visit>
  static std::vector<Item> gather (std::size_t n, const Visit& visit)
  {
    std::vector<std::vector<Item>> parts (n / PIECE + 1);
    parallelFor (
      parts.size (),
      [&] (std::size_t part) {
        for (std::size_t i = part * PIECE; i < std::min (n, (part + 1) * PIECE); ++i)
          visit (i, [&] (const Item& item) { parts[part].push_back (item); });
      },
      1);
    std::size_t total = 0;
    for (const auto& part : parts)
      total += part.size ();
    std::vector<Item> list;
    list.reserve (total);
    for (const auto& part : parts)
      list.insert (list.end (), part.begin (), part.end ());
    return list;
  }

  // The sets that a wish may join now; it is offered to both.
  Open look (const Open& open)
  {
    const std::uint32_t a = forest_.look (open.a).first;
    const std::uint32_t b = forest_.look (open.b).first;
    if (a != b) {
      offer (a, keyOf (open.wish));
      offer (b, keyOf (open.wish));
    }
    return {open.wish, a, b};
  }

  void offer (std::uint32_t root, std::uint64_t key)
  {
    std::uint64_t now = first_[root].load (std::memory_order_relaxed);
    while (key < now && !first_[root].compare_exchange_weak (now, key, std::memory_order_relaxed)) {
    }
  }

  // Every set is joined to that at the other end of its first wish. Keys are distinct, so the only rings are
  // pairs of sets with the same first wish, of which the one with the smaller root stays.
  void grantFirst (std::vector<std::uint32_t>& roots)
  {
    std::vector<std::uint32_t> links (roots.size ());
    parallelFor (roots.size (), [&] (std::size_t i) { links[i] = linkOf (roots[i]); });
    parallelFor (roots.size (), [&] (std::size_t i) {
      first_[roots[i]].store (NONE, std::memory_order_relaxed);
      forest_.link (roots[i], links[i] >> 1, links[i] & 1);
    });
    parallelFor (roots.size (), [&] (std::size_t i) { forest_.shorten (roots[i]); });
    std::size_t kept = 0;
    for (std::size_t i = 0; i < roots.size (); ++i)
      if (links[i] == roots[i] << 1)
        roots[kept++] = roots[i];
    roots.resize (kept);
  }

  // What a root is to be linked to, other root << 1 | parity; itself if it stays a root.
  std::uint32_t linkOf (std::uint32_t root) const
  {
    const std::uint64_t key = first_[root].load (std::memory_order_relaxed);
    if (key == NONE)
      return root << 1;
    const Wish wish = WishKey::wishOf (key);
    const auto [a, b] = wishes_.ends (wish);
    const auto [root_a, parity_a] = forest_.look (a);
    const auto [root_b, parity_b] = forest_.look (b);
    const std::uint32_t other = root_a == root ? root_b : root_a;
    if (first_[other].load (std::memory_order_relaxed) == key && root < other)
      return root << 1;
    return other << 1 | (parity_a ^ parity_b ^ (wishes_.opposite (wish) ? 1u : 0u));
  }

  const Wishes& wishes_;
  ParityForest& forest_;
  std::size_t few_;
  std::vector<std::atomic<std::uint64_t>> first_; // per root the key of its set's first wish
};

} // namespace manifold
} // namespace pcl
