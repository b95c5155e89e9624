#pragma once

#include <pcl/types.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace pcl {
namespace manifold {

/** Collects the k nearest of the points that it is shown; of equally near ones those of smaller index.
 *
 * Points are appended without a branch, and only now and then all but the k nearest are dropped, by a search
 * for the distance that divides them: processors mispredict about every other insertion into a heap or a
 * sorted array. */
class NearestCandidates
{
public:
  /** At most `chunk` points are shown at a time. */
  NearestCandidates (std::size_t k, std::size_t chunk);

  /** Forgets everything. Points farther than the bound will not be wanted. */
  void start (double squared_bound)
  {
    size_ = 0;
    bound_ = squared_bound;
  }

  void add (const double* squared_distances, const pcl::index_t* indices, std::size_t count)
  {
    double* const distances = distances_.data ();
    pcl::index_t* const kept = indices_.data ();
    const double bound = bound_;
    std::size_t size = size_;
    for (std::size_t i = 0; i < count; ++i) {
      distances[size] = squared_distances[i];
      kept[size] = indices[i];
      size += squared_distances[i] <= bound ? 1 : 0;
    }
    size_ = size;
    if (size_ > 2 * k_)
      dropFarther ();
  }

  /** Drops all but the k nearest, if there are as many, and makes the distance of the last the bound. */
  void dropFarther ();

  std::size_t size () const { return size_; }

  /** No point farther than this is among the k nearest. */
  double squaredBound () const { return bound_; }

  /** In no particular order. */
  const double* squaredDistances () const { return distances_.data (); }

  const pcl::index_t* indices () const { return indices_.data (); }

private:
  std::size_t k_;
  std::size_t size_ = 0;
  double bound_ = 0.0;
  std::vector<double> distances_;
  std::vector<pcl::index_t> indices_;
  std::vector<std::pair<double, pcl::index_t>> undecided_;
};

} // namespace manifold
} // namespace pcl
