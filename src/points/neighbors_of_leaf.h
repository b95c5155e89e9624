#pragma once

#include "points/kd_tree.h"
#include "points/nearest_candidates.h"

#include <array>
#include <utility>
#include <vector>

namespace pcl {
namespace manifold {

/** Finds the k nearest neighbours of all points of a leaf of a kd-tree. They are near each other: the tree is
 * walked once for all of them, and the neighbours of those that are done bound those of the others. */
template <int D>
class NeighborsOfLeaf
{
public:
  /** k at least 1 and smaller than the number of points. */
  NeighborsOfLeaf (const KdTree<D>& tree, std::size_t k);

  /** Writes the rows of the points of a leaf to their places in the rows of all points. */
  void find (std::size_t leaf, pcl::index_t* rows);

private:
  double boundForFirst (std::size_t leaf);
  double boundByOthers (std::size_t first, std::size_t at);
  void findLeavesAround (std::size_t leaf, double radius);
  void lookAt (std::size_t first, std::size_t last);

  const KdTree<D>& tree_;
  std::size_t k_;
  NearestCandidates candidates_;
  std::vector<double> point_;                          ///< that is searched for
  std::vector<std::pair<double, std::size_t>> leaves_; ///< by their squared distance from the leaf
  std::vector<std::size_t> stack_;
  std::array<double, KdTree<D>::LEAF_SIZE> radii_; ///< per point of the leaf that of its neighbourhood
  std::array<double, KdTree<D>::LEAF_SIZE> distances_;
};

} // namespace manifold
} // namespace pcl
