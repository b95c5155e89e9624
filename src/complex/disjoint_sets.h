#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace pcl {
namespace manifold {

/** \brief Disjoint sets of the numbers 0 to n - 1. The representative of a set is its smallest number, so
 * that it does not depend on the order in which sets were joined. */
class DisjointSets
{
public:
  explicit DisjointSets (std::size_t size) : parent_ (size)
  {
    std::iota (parent_.begin (), parent_.end (), 0u);
  }

  std::uint32_t find (std::uint32_t i)
  {
    while (parent_[i] != i)
      i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  void join (std::uint32_t a, std::uint32_t b)
  {
    a = find (a);
    b = find (b);
    if (a < b)
      std::swap (a, b);
    parent_[a] = b;
  }

  /** \brief Numbers the sets 0, 1, 2, ... by their smallest members.
   * \param[out] numbers for every member the number of its set
   * \return how many sets there are */
  std::uint32_t number (std::vector<std::uint32_t>& numbers)
  {
    numbers.resize (parent_.size ());
    std::uint32_t sets = 0;
    for (std::uint32_t i = 0; i < parent_.size (); ++i) {
      const std::uint32_t root = find (i);
      numbers[i] = root == i ? sets++ : numbers[root];
    }
    return sets;
  }

private:
  std::vector<std::uint32_t> parent_;
};

} // namespace manifold
} // namespace pcl
