#include "voronoi/nearest_samples.h"

#include "voronoi/voronoi_cell.h"

#include <algorithm>
#include <functional>

namespace pcl {
namespace manifold {

const std::vector<std::int32_t>&
NearestSamples::find (std::int32_t sample, int k)
{
  const Eigen::Matrix3Xd& points = complex_.samples->points;
  queue_.clear ();
  found_.clear ();
  seen_.assign (1, sample);
  const auto lookAround = [&] (std::int32_t center) {
    const auto old = static_cast<std::ptrdiff_t> (seen_.size ());
    VoronoiCell (complex_, center).forEachNeighbor ([this] (std::int32_t q) { seen_.push_back (q); });
    std::sort (seen_.begin () + old, seen_.end ());
    seen_.erase (std::unique (seen_.begin () + old, seen_.end ()), seen_.end ());
    for (auto q = seen_.begin () + old; q != seen_.end (); ++q)
      if (!std::binary_search (seen_.begin (), seen_.begin () + old, *q)) {
        queue_.emplace_back ((points.col (*q) - points.col (sample)).squaredNorm (), *q);
        std::push_heap (queue_.begin (), queue_.end (), std::greater<> ());
      }
    std::inplace_merge (seen_.begin (), seen_.begin () + old, seen_.end ());
    seen_.erase (std::unique (seen_.begin (), seen_.end ()), seen_.end ());
  };
  lookAround (sample);
  while (!queue_.empty () && found_.size () < static_cast<std::size_t> (k)) {
    std::pop_heap (queue_.begin (), queue_.end (), std::greater<> ());
    const std::int32_t nearest = queue_.back ().second;
    queue_.pop_back ();
    found_.push_back (nearest);
    if (found_.size () < static_cast<std::size_t> (k))
      lookAround (nearest);
  }
  return found_;
}

} // namespace manifold
} // namespace pcl
