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
  explicit ParityForest (std::size_t n) : link_ (n)
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
    parallelFor (link_.size (), [this] (std::size_t i) { shorten (static_cast<std::uint32_t> (i)); });
  }

  /** Links an element to its root: safe from several threads at once, also beside look. */
  void shorten (std::uint32_t element)
  {
    const auto [root, parity] = look (element);
    set (element, root, parity);
  }

  /** Joins the sets of two elements of the same or of opposite colours, unless they are in one set already.
   */
  bool unite (std::uint32_t a, std::uint32_t b, bool opposite)
  {
    const auto [root_a, parity_a] = find (a);
    const auto [root_b, parity_b] = find (b);
    if (root_a == root_b)
      return false;
    link (root_b, root_a, parity_a ^ parity_b ^ (opposite ? 1u : 0u));
    return true;
  }

  /** Links a root to another element, whose colour it has (parity 0) or not (1); not to one of its own set.
   */
  void link (std::uint32_t root, std::uint32_t element, std::uint32_t parity) { set (root, element, parity); }

  std::size_t size () const { return link_.size (); }

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
};

} // namespace manifold
} // namespace pcl
