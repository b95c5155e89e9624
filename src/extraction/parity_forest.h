#pragma once

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
    for (std::size_t i = 0; i < n; ++i)
      link_[i] = static_cast<std::uint32_t> (i) << 1;
  }

  /** The root of the element's set, and whether its colour differs from the root's. */
  std::pair<std::uint32_t, std::uint32_t> find (std::uint32_t element)
  {
    std::uint32_t parity = 0;
    std::uint32_t link = link_[element];
    while (link >> 1 != element) {
      const std::uint32_t next = link_[link >> 1];
      // Path halving: link the element to its grandparent, or to the root.
      if (next >> 1 != link >> 1)
        link = next ^ (link & 1);
      link_[element] = link;
      parity ^= link & 1;
      element = link >> 1;
      link = link_[element];
    }
    return {element, parity};
  }

  /** The same without shortening the way to the root for later calls: safe from several threads at once. */
  std::pair<std::uint32_t, std::uint32_t> look (std::uint32_t element) const
  {
    std::uint32_t parity = 0;
    for (std::uint32_t link = link_[element]; link >> 1 != element; link = link_[element]) {
      parity ^= link & 1;
      element = link >> 1;
    }
    return {element, parity};
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
    link_[root_b] = root_a << 1 | (parity_a ^ parity_b ^ (opposite ? 1u : 0u));
    size_[root_a] += size_[root_b];
    return true;
  }

private:
  std::vector<std::uint32_t> link_; // parent << 1 | colour relative to the parent
  std::vector<std::uint32_t> size_;
};

} // namespace manifold
} // namespace pcl
