#include "points/nearest_candidates.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl {
namespace manifold {

namespace {

// The search for the dividing distance ends after so many guesses. It takes about four, if there are no ties.
constexpr int MAX_GUESSES = 9;

std::size_t
countNearer (const std::vector<double>& distances, std::size_t size, double than)
{
  std::size_t count = 0;
  for (std::size_t i = 0; i < size; ++i)
    count += distances[i] < than ? 1 : 0;
  return count;
}

} // namespace

NearestCandidates::NearestCandidates (std::size_t k, std::size_t chunk)
  : k_ (k), distances_ (2 * k + chunk + 1), indices_ (distances_.size ())
{}

void
NearestCandidates::dropFarther ()
{
  if (size_ < k_)
    return;
  // At most k points, `sure` of them, are nearer than low, and at least k, `possible` of them, nearer than
  // high.
  double low = 0.0;
  const double farthest =
    std::isfinite (bound_) ? bound_ : *std::max_element (distances_.begin (), distances_.begin () + size_);
  double high = std::nextafter (farthest, std::numeric_limits<double>::infinity ());
  std::size_t sure = 0;
  std::size_t possible = size_;
  for (int guess = 0; guess < MAX_GUESSES && sure < k_ && possible > k_; ++guess) {
    // Squared distances of points on a surface are spread evenly; where they are not, halving helps.
    const double share =
      guess % 3 == 2 ? 0.5 : static_cast<double> (k_ - sure) / static_cast<double> (possible - sure);
    const double divider = low + (high - low) * share;
    const std::size_t nearer = countNearer (distances_, size_, divider);
    if (nearer <= k_) {
      low = divider;
      sure = nearer;
    } else {
      high = divider;
      possible = nearer;
    }
  }
  if (possible == k_)
    low = high;

  undecided_.clear ();
  if (sure < k_ && possible > k_)
    for (std::size_t i = 0; i < size_; ++i)
      if (distances_[i] >= low && distances_[i] < high)
        undecided_.emplace_back (distances_[i], indices_[i]);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < size_; ++i) {
    const double distance = distances_[i];
    distances_[kept] = distance;
    indices_[kept] = indices_[i];
    kept += distance < low ? 1 : 0;
  }
  if (kept < k_) {
    const auto missing = static_cast<std::ptrdiff_t> (k_ - kept);
    std::nth_element (undecided_.begin (), undecided_.begin () + missing - 1, undecided_.end ());
    for (std::ptrdiff_t i = 0; i < missing; ++i, ++kept) {
      distances_[kept] = undecided_[i].first;
      indices_[kept] = undecided_[i].second;
    }
  }
  size_ = kept;
  bound_ = *std::max_element (distances_.begin (), distances_.begin () + size_);
}

} // namespace manifold
} // namespace pcl
