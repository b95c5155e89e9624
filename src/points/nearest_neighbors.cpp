#include "points/nearest_neighbors.h"

#include "common/large_pages.h"
#include "common/parallel.h"
#include "points/kd_tree.h"
#include "points/neighbors_of_leaf.h"

#include <algorithm>
#include <limits>

namespace pcl {
namespace manifold {

namespace {

constexpr std::size_t LEAVES_PER_TASK = 128;

// So many neighbours are looked for before the user is asked whether to go on: less than a second's work.
constexpr std::size_t NEIGHBORS_PER_QUESTION = std::size_t (1) << 22;
constexpr std::size_t QUERIES_PER_TASK = 4096;

template <int D>
std::vector<pcl::index_t>
neighborsOfAll (const Eigen::Ref<const Eigen::MatrixXd>& points, std::size_t k,
                const ProgressCallback& progress)
{
  const KdTree<D> tree (points);
  std::vector<pcl::index_t> neighbors;
  assignLarge (neighbors, tree.size () * k);
  const std::size_t leaves_per_question = NEIGHBORS_PER_QUESTION / (KdTree<D>::LEAF_SIZE * k) + 1;
  for (std::size_t done = 0; done < tree.leaves ();) {
    const std::size_t piece = std::min (tree.leaves () - done, leaves_per_question);
    const auto search = [&] (std::size_t begin, std::size_t end) {
      NeighborsOfLeaf<D> neighbors_of_leaf (tree, k);
      for (std::size_t leaf = begin; leaf < end; ++leaf)
        neighbors_of_leaf.find (tree.leaves () + done + leaf, neighbors.data ());
    };
    parallelRanges (piece, search, LEAVES_PER_TASK);
    done += piece;
    if (progress && !progress (static_cast<float> (done) / static_cast<float> (tree.leaves ())))
      return {};
  }
  return neighbors;
}

// Depth first, nearer boxes first.
class NearestPoint
{
public:
  explicit NearestPoint (const KdTree<3>& tree) : tree_ (tree) {}

  pcl::index_t find (const double* query)
  {
    best_ = {std::numeric_limits<double>::infinity (), 0};
    stack_.assign (1, {0.0, 1});
    while (!stack_.empty ()) {
      const auto [distance, node] = stack_.back ();
      stack_.pop_back ();
      if (distance > best_.first)
        continue;
      if (tree_.isLeaf (node)) {
        look (query, node);
        continue;
      }
      const std::pair<double, std::size_t> left (tree_.toBox (query, 2 * node), 2 * node);
      const std::pair<double, std::size_t> right (tree_.toBox (query, 2 * node + 1), 2 * node + 1);
      stack_.push_back (std::max (left, right));
      stack_.push_back (std::min (left, right));
    }
    return best_.second;
  }

private:
  void look (const double* query, std::size_t leaf)
  {
    double distances[KdTree<3>::LEAF_SIZE];
    const std::size_t first = tree_.begin (leaf);
    const std::size_t last = tree_.end (leaf);
    tree_.squaredDistances (query, first, last, distances);
    for (std::size_t i = first; i < last; ++i)
      best_ = std::min (best_, std::make_pair (distances[i - first], tree_.indices ()[i]));
  }

  const KdTree<3>& tree_;
  std::pair<double, pcl::index_t> best_;
  std::vector<std::pair<double, std::size_t>> stack_;
};

} // namespace

std::vector<pcl::index_t>
kNearestNeighbors (const Eigen::Ref<const Eigen::MatrixXd>& points, int k, const ProgressCallback& progress)
{
  if (points.cols () == 0 || k < 1)
    return {};
  const auto neighbors = static_cast<std::size_t> (k);
  return points.rows () == 3 ? neighborsOfAll<3> (points, neighbors, progress)
                             : neighborsOfAll<Eigen::Dynamic> (points, neighbors, progress);
}

std::vector<std::int32_t>
nearestPoints (const Eigen::Matrix3Xd& points, const Eigen::Matrix3Xd& queries)
{
  const KdTree<3> tree (points);
  std::vector<std::int32_t> nearest (static_cast<std::size_t> (queries.cols ()));
  const auto search = [&] (std::size_t begin, std::size_t end) {
    NearestPoint nearest_point (tree);
    for (std::size_t i = begin; i < end; ++i)
      nearest[i] =
        static_cast<std::int32_t> (nearest_point.find (queries.col (static_cast<Eigen::Index> (i)).data ()));
  };
  parallelRanges (nearest.size (), search, QUERIES_PER_TASK);
  return nearest;
}

} // namespace manifold
} // namespace pcl
