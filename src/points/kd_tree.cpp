#include "points/kd_tree.h"

#include "common/large_pages.h"
#include "common/parallel.h"

#include <tbb/parallel_invoke.h>

#include <numeric>

namespace pcl {
namespace manifold {

namespace {

// Fewer points than this are not worth a task of their own.
constexpr std::size_t POINTS_PER_TASK = 8192;

// So many points of a node show which side of it is the longest.
constexpr std::size_t SAMPLE_SIZE = 64;

} // namespace

template <int D>
KdTree<D>::KdTree (const Eigen::Ref<const Eigen::MatrixXd>& points)
  : dimension_ (static_cast<int> (points.rows ())), index_ (static_cast<std::size_t> (points.cols ()))
{
  while (size () > LEAF_SIZE << levels_)
    ++levels_;
  std::iota (index_.begin (), index_.end (), 0);
  boxes_.resize (4 * leaves () * static_cast<std::size_t> (dimension ()));
  {
    std::vector<Key> keys;
    assignLarge (keys, size ());
    split (points, 1, keys);
  }
  assignLarge (coordinates_, static_cast<std::size_t> (dimension ()) * size ());
  parallelFor (size (), [&] (std::size_t i) {
    for (int axis = 0; axis < dimension (); ++axis)
      coordinates_[static_cast<std::size_t> (axis) * size () + i] = points (axis, index_[i]);
  });
}

// Divides the points of a node among its children, and computes its box from theirs.
template <int D>
void
KdTree<D>::split (const Eigen::Ref<const Eigen::MatrixXd>& points, std::size_t node, std::vector<Key>& keys)
{
  const std::size_t first = begin (node);
  const std::size_t last = end (node);
  if (isLeaf (node)) {
    enclose (points, node, 1);
    return;
  }

  // By the median along the side that is longest as far as a sample of the points shows.
  enclose (points, node, (last - first) / SAMPLE_SIZE + 1);
  int longest = 0;
  for (int axis = 1; axis < dimension (); ++axis)
    if (high (node)[axis] - low (node)[axis] > high (node)[longest] - low (node)[longest])
      longest = axis;
  for (std::size_t i = first; i < last; ++i)
    keys[i] = {points (longest, index_[i]), index_[i]};
  std::nth_element (keys.data () + first, keys.data () + end (2 * node), keys.data () + last,
                    [] (const Key& a, const Key& b) { return a.coordinate < b.coordinate; });
  for (std::size_t i = first; i < last; ++i)
    index_[i] = keys[i].index;

  const auto splitLeft = [&] { split (points, 2 * node, keys); };
  const auto splitRight = [&] { split (points, 2 * node + 1, keys); };
  if (last - first > POINTS_PER_TASK) {
    tbb::parallel_invoke (splitLeft, splitRight);
  } else {
    splitLeft ();
    splitRight ();
  }
  for (int axis = 0; axis < dimension (); ++axis) {
    low (node)[axis] = std::min (low (2 * node)[axis], low (2 * node + 1)[axis]);
    high (node)[axis] = std::max (high (2 * node)[axis], high (2 * node + 1)[axis]);
  }
}

// Makes the box of a node that of every so many of its points.
template <int D>
void
KdTree<D>::enclose (const Eigen::Ref<const Eigen::MatrixXd>& points, std::size_t node, std::size_t step)
{
  double* lowest = low (node);
  double* highest = high (node);
  for (int axis = 0; axis < dimension (); ++axis)
    lowest[axis] = highest[axis] = points (axis, index_[begin (node)]);
  for (std::size_t i = begin (node); i < end (node); i += step)
    for (int axis = 0; axis < dimension (); ++axis) {
      lowest[axis] = std::min (lowest[axis], points (axis, index_[i]));
      highest[axis] = std::max (highest[axis], points (axis, index_[i]));
    }
}

template class KdTree<3>;
template class KdTree<Eigen::Dynamic>;

} // namespace manifold
} // namespace pcl
