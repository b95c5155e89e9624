#include "voronoi/nearest_samples.h"

#include "voronoi/voronoi_cell.h"

#include <algorithm>
#include <functional>

namespace pcl {
namespace manifold {

NearestSamples::NearestSamples (const DelaunayComplex& complex)
  : complex_ (complex), seen_in_ (static_cast<std::size_t> (complex.samples->size ()), 0)
{}

const std::vector<std::int32_t>&
NearestSamples::find (std::int32_t sample, int k)
{
  const VoronoiCell cell (complex_, sample);
  queue_.clear ();
  found_.clear ();
  seen_in_[sample] = ++call_;
  const auto lookAround = [&] (const VoronoiCell& center) {
    center.visitNeighbors ([&] (std::int32_t q) {
      if (seen_in_[q] == call_)
        return;
      seen_in_[q] = call_;
      queue_.emplace_back (cell.relative (q).squaredNorm (), q);
      std::push_heap (queue_.begin (), queue_.end (), std::greater<> ());
    });
  };
  lookAround (cell);
  while (!queue_.empty () && found_.size () < static_cast<std::size_t> (k)) {
    std::pop_heap (queue_.begin (), queue_.end (), std::greater<> ());
    const std::int32_t nearest = queue_.back ().second;
    queue_.pop_back ();
    found_.push_back (nearest);
    if (found_.size () < static_cast<std::size_t> (k))
      lookAround (VoronoiCell (complex_, nearest));
  }
  return found_;
}

} // namespace manifold
} // namespace pcl
