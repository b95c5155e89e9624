#pragma once

#include <pcl/manifold/delaunay_complex.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace pcl {
namespace manifold {

/** Exact nearest samples of a sample by a walk over the Delaunay edges: the next nearest is always a Delaunay
 * neighbour of the sample itself or of one already found. Keeps its scratch memory between calls; one object
 * a thread. */
class NearestSamples
{
public:
  explicit NearestSamples (const DelaunayComplex& complex);

  /** The k nearest other samples of a sample, nearest first (ties by number); fewer where there are not so
   * many. Valid until the next call. */
  const std::vector<std::int32_t>& find (std::int32_t sample, int k);

private:
  const DelaunayComplex& complex_;
  std::vector<std::pair<double, std::int32_t>> queue_;
  std::uint32_t call_ = 0;
  std::vector<std::uint32_t> seen_in_; // the last call that came across a sample
  std::vector<std::int32_t> found_;
};

} // namespace manifold
} // namespace pcl
