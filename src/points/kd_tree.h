#pragma once

#include <pcl/types.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace pcl {
namespace manifold {

/** A balanced kd-tree, with the points copied in the order of its leaves, one array an axis, so that the
 * distances of a leaf are computed on vectors.
 *
 * Nodes are numbered as in a heap: the root is 1, the children of a node are 2 * node and 2 * node + 1, and
 * the leaves are the last ones. Squared distances are sums in the order of the axes: rounding is monotonic,
 * so none to a box is, as computed, larger than one to a point in the box, and what is found is exact.
 *
 * D is the dimension, or Eigen::Dynamic. */
template <int D>
class KdTree
{
public:
  static constexpr std::size_t LEAF_SIZE = 16; ///< no leaf has more points

  /** Of at least one point, whose squared distances must be finite. Parallel in the current arena. */
  explicit KdTree (const Eigen::Ref<const Eigen::MatrixXd>& points);

  int dimension () const { return D == Eigen::Dynamic ? dimension_ : D; }

  std::size_t size () const { return index_.size (); }

  std::size_t leaves () const { return std::size_t (1) << levels_; }

  bool isLeaf (std::size_t node) const { return node >= leaves (); }

  /** The points in a node are those at the positions from begin (node) to before end (node). */
  std::size_t begin (std::size_t node) const { return position (node, 0); }

  std::size_t end (std::size_t node) const { return position (node, 1); }

  /** The numbers that the points at positions have for the caller. */
  const pcl::index_t* indices () const { return index_.data (); }

  void copyPoint (std::size_t at, double* point) const
  {
    for (int axis = 0; axis < dimension (); ++axis)
      point[axis] = along (axis)[at];
  }

  /** Squared distances from a point to those at positions. */
  void squaredDistances (const double* point, std::size_t first, std::size_t last, double* distances) const
  {
    if constexpr (D == 3) {
      const double* x = along (0) + first;
      const double* y = along (1) + first;
      const double* z = along (2) + first;
      const double a = point[0], b = point[1], c = point[2];
      for (std::size_t i = 0; i < last - first; ++i)
        distances[i] = square (x[i] - a) + square (y[i] - b) + square (z[i] - c);
      return;
    }
    std::fill_n (distances, last - first, 0.0);
    for (int axis = 0; axis < dimension (); ++axis) {
      const double* coordinates = along (axis) + first;
      for (std::size_t i = 0; i < last - first; ++i)
        distances[i] += square (coordinates[i] - point[axis]);
    }
  }

  /** Squared distance from a point to the bounding box of a node. */
  double toBox (const double* point, std::size_t node) const
  {
    double sum = 0.0;
    for (int axis = 0; axis < dimension (); ++axis)
      sum += square (gap (low (node)[axis] - point[axis], point[axis] - high (node)[axis]));
    return sum;
  }

  /** Squared distance between the bounding boxes of nodes. */
  double betweenBoxes (std::size_t a, std::size_t b) const
  {
    double sum = 0.0;
    for (int axis = 0; axis < dimension (); ++axis)
      sum += square (gap (low (a)[axis] - high (b)[axis], low (b)[axis] - high (a)[axis]));
    return sum;
  }

  /** Squared distance from a point to the farthest corner of the bounding box of a node. */
  double toFarCorner (const double* point, std::size_t node) const
  {
    double sum = 0.0;
    for (int axis = 0; axis < dimension (); ++axis)
      sum += square (std::max (high (node)[axis] - point[axis], point[axis] - low (node)[axis]));
    return sum;
  }

private:
  struct Key
  {
    double coordinate;
    pcl::index_t index;
  };

  static double square (double x) { return x * x; }

  static double gap (double below, double above) { return std::max (std::max (below, above), 0.0); }

  // The point at a share of its level's points: side 0 is the begin of a node, 1 its end.
  std::size_t position (std::size_t node, std::size_t side) const
  {
    int level = levels_;
    while (node >> level == 0)
      --level;
    return size () * (node + side - (std::size_t (1) << level)) >> level;
  }

  const double* along (int axis) const
  {
    return coordinates_.data () + static_cast<std::size_t> (axis) * size ();
  }

  const double* low (std::size_t node) const
  {
    return boxes_.data () + 2 * node * static_cast<std::size_t> (dimension ());
  }

  const double* high (std::size_t node) const { return low (node) + dimension (); }

  double* low (std::size_t node)
  {
    return boxes_.data () + 2 * node * static_cast<std::size_t> (dimension ());
  }

  double* high (std::size_t node) { return low (node) + dimension (); }

  void split (const Eigen::Ref<const Eigen::MatrixXd>& points, std::size_t node, std::vector<Key>& keys);
  void enclose (const Eigen::Ref<const Eigen::MatrixXd>& points, std::size_t node, std::size_t step);

  int dimension_ = 0;
  int levels_ = 0;
  std::vector<pcl::index_t> index_;
  std::vector<double> coordinates_; ///< all of the first axis, then all of the second, ...
  std::vector<double> boxes_;       ///< per node its lowest and its highest corner
};

} // namespace manifold
} // namespace pcl
