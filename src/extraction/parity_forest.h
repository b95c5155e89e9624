#pragma once

#include "common/parallel.h"

#include <atomic>
#include <cstdint>
#include <utility>
#include <vector>

namespace pcl {
namespace manifold {

/** Disjoint sets of elements that each have one of two colours relative to the others of their set. */
class ParityForest
{
public:
  explicit ParityForest (std::size_t n) : link_ (n), size_ (n, 1)
  {
    parallelFor (
      n, [this] (std::size_t i) { set (static_cast<std::uint32_t> (i), static_cast<std::uint32_t> (i), 0); });
  }

  /** The root of the element's set, and whether its colour differs from the root's. */
  std::pair<std::uint32_t, std::uint32_t> find (std::uint32_t element)
  {
    std::uint32_t parity = 0;
    std::uint32_t link = linkOf (element);
    while (link >> 1 != element) {
      const std::uint32_t next = linkOf (link >> 1);
      // Path halving: link the element to its grandparent, or to the root.
      if (next >> 1 != link >> 1)
        link = next ^ (link & 1);
      set (element, link >> 1, link & 1);
      parity ^= link & 1;
      element = link >> 1;
      link = linkOf (element);
    }
    return {element, parity};
  }

  /** The same without shortening the way to the root for later calls: safe from several threads at once. */
  std::pair<std::uint32_t, std::uint32_t> look (std::uint32_t element) const
  {
    std::uint32_t parity = 0;
    for (std::uint32_t link = linkOf (element); link >> 1 != element; link = linkOf (element)) {
      parity ^= link & 1;
      element = link >> 1;
    }
    return {element, parity};
  }

  /** Links every element to its root, in parallel: makes later calls of find and look short. */
  void compress ()
  {
    parallelFor (link_.size (), [this] (std::size_t i) {
      const auto [root, parity] = look (static_cast<std::uint32_t> (i));
      set (static_cast<std::uint32_t> (i), root, parity);
    });
  }

  /** Joins the sets of two elements of the same or of opposite colours, unless they are in one set already.
   */
  bool unite (std::uint32_t a, std::uint32_t b, bool opposite)
  {
    auto [root_a, parity_a] = find (a);
    auto [root_b, parity_b] = find (b);
    if (root_a == root_b)
      return false;
    if (size_[root_a] < size_[root_b])
      std::swap (root_a, root_b);
    set (root_b, root_a, parity_a ^ parity_b ^ (opposite ? 1u : 0u));
    size_[root_a] += size_[root_b];
    return true;
  }

private:
  std::uint32_t linkOf (std::uint32_t element) const
  {
    return link_[element].load (std::memory_order_relaxed);
  }

  void set (std::uint32_t element, std::uint32_t parent, std::uint32_t parity)
  {
    link_[element].store (parent << 1 | parity, std::memory_order_relaxed);
  }

  // Atomic for compress: other threads may look along a way that is being shortened, and either is right.
  std::vector<std::atomic<std::uint32_t>> link_; // parent << 1 | colour relative to the parent
  std::vector<std::uint32_t> size_;
};

} // namespace manifold
} // namespace pcl
