#include "points/neighbors_of_leaf.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl {
namespace manifold {

namespace {

// Makes up for what rounding, and for tiny distances underflow, may take from a radius.
constexpr double RELATIVE_SLACK = 1.0 + 1e-9;
constexpr double ABSOLUTE_SLACK = 0x1p-500;

double
squaredBound (double radius)
{
  radius = (radius + ABSOLUTE_SLACK) * RELATIVE_SLACK;
  return radius * radius;
}

// Short rows are sorted by counting, for every number, how many are smaller: that takes no branches.
void
sortRow (const pcl::index_t* numbers, std::size_t count, pcl::index_t* row)
{
  constexpr std::size_t SHORT = 32;
  if (count > SHORT) {
    std::copy_n (numbers, count, row);
    std::sort (row, row + count);
    return;
  }
  std::array<pcl::index_t, SHORT> padded;
  padded.fill (std::numeric_limits<pcl::index_t>::max ());
  std::copy_n (numbers, count, padded.begin ());
  const std::size_t compared = (count + 3) / 4 * 4;
  for (std::size_t i = 0; i < count; ++i) {
    int smaller = 0;
    for (std::size_t j = 0; j < compared; ++j)
      smaller += padded[j] < padded[i] ? 1 : 0;
    row[smaller] = padded[i];
  }
}

} // namespace

template <int D>
NeighborsOfLeaf<D>::NeighborsOfLeaf (const KdTree<D>& tree, std::size_t k)
  : tree_ (tree), k_ (k), candidates_ (k, KdTree<D>::LEAF_SIZE),
    point_ (static_cast<std::size_t> (tree.dimension ()))
{}

template <int D>
void
NeighborsOfLeaf<D>::find (std::size_t leaf, pcl::index_t* rows)
{
  const std::size_t first = tree_.begin (leaf);
  const std::size_t last = tree_.end (leaf);
  for (std::size_t at = first; at < last; ++at) {
    tree_.copyPoint (at, point_.data ());
    const double radius = at == first ? boundForFirst (leaf) : boundByOthers (first, at);
    if (at == first)
      findLeavesAround (leaf, radius);
    candidates_.start (squaredBound (radius));
    lookAt (first, at);
    lookAt (at + 1, last);
    for (const auto& [distance, other] : leaves_) {
      if (distance > candidates_.squaredBound ())
        break;
      if (tree_.toBox (point_.data (), other) <= candidates_.squaredBound ())
        lookAt (tree_.begin (other), tree_.end (other));
    }
    candidates_.dropFarther ();
    radii_[at - first] = std::sqrt (candidates_.squaredBound ());
    sortRow (candidates_.indices (), k_, rows + static_cast<std::size_t> (tree_.indices ()[at]) * k_);
  }
}

// The distance of the k-th nearest to the first point of a leaf in the smallest node around it that has as
// many.
template <int D>
double
NeighborsOfLeaf<D>::boundForFirst (std::size_t leaf)
{
  std::size_t node = leaf;
  while (tree_.end (node) - tree_.begin (node) <= k_)
    node /= 2;
  candidates_.start (std::numeric_limits<double>::infinity ());
  const auto lookAtPieces = [&] (std::size_t begin, std::size_t end) {
    for (; begin < end; begin += KdTree<D>::LEAF_SIZE)
      lookAt (begin, std::min (end, begin + KdTree<D>::LEAF_SIZE));
  };
  lookAtPieces (tree_.begin (node), tree_.begin (leaf));
  lookAtPieces (tree_.begin (leaf) + 1, tree_.end (node));
  candidates_.dropFarther ();
  return std::sqrt (candidates_.squaredBound ());
}

// The ball around another point that holds its neighbours, moved here, holds them if it grows by the distance
// of both points.
template <int D>
double
NeighborsOfLeaf<D>::boundByOthers (std::size_t first, std::size_t at)
{
  tree_.squaredDistances (point_.data (), first, at, distances_.data ());
  double radius = std::numeric_limits<double>::infinity ();
  for (std::size_t i = 0; i < at - first; ++i)
    radius = std::min (radius, radii_[i] + std::sqrt (distances_[i]));
  return radius;
}

// The leaves that may hold a neighbour of any point of a leaf; those of the first, which is point_, are in a
// radius around it.
template <int D>
void
NeighborsOfLeaf<D>::findLeavesAround (std::size_t leaf, double radius)
{
  const double reach = squaredBound (radius + std::sqrt (tree_.toFarCorner (point_.data (), leaf)));
  leaves_.clear ();
  stack_.assign (1, 1);
  while (!stack_.empty ()) {
    const std::size_t node = stack_.back ();
    stack_.pop_back ();
    const double distance = tree_.betweenBoxes (leaf, node);
    if (distance > reach || node == leaf)
      continue;
    if (tree_.isLeaf (node)) {
      leaves_.emplace_back (distance, node);
    } else {
      stack_.push_back (2 * node);
      stack_.push_back (2 * node + 1);
    }
  }
  std::sort (leaves_.begin (), leaves_.end ());
}

template <int D>
void
NeighborsOfLeaf<D>::lookAt (std::size_t first, std::size_t last)
{
  tree_.squaredDistances (point_.data (), first, last, distances_.data ());
  candidates_.add (distances_.data (), tree_.indices () + first, last - first);
}

template class NeighborsOfLeaf<3>;
template class NeighborsOfLeaf<Eigen::Dynamic>;

} // namespace manifold
} // namespace pcl
