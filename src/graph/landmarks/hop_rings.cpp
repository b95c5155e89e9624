#include "graph/landmarks/hop_rings.h"

#include "common/large_pages.h"

#include <algorithm>

namespace pcl {
namespace manifold {

namespace {

constexpr int OUTSIDE = -1;

// Parts of a ring that have fewer vertices, or are a smaller share of it, are frayed ends.
constexpr std::size_t FEWEST_VERTICES = 3;
constexpr std::size_t SMALLEST_SHARE = 4;

// Rings are looked at in bands of so many: single ones fall apart by chance.
constexpr int BAND = 2;

// Added to the hops of vertices whose part of a band was counted.
constexpr int COUNTED = 1 << 30;

} // namespace

HopRings::HopRings (const NeighborhoodGraph& graph) : graph_ (graph)
{
  assignLarge (hops_, static_cast<std::size_t> (graph.size ()), OUTSIDE);
}

int
HopRings::radiusOfDisk (pcl::index_t center, int least, int most)
{
  vertices_.assign (1, center);
  hops_[center] = 0;
  int radius = 0;
  std::size_t begin = 0; // of the outermost ring
  std::size_t band = 1;  // of the band that this ring is in
  for (int hops = 1;; ++hops) {
    const std::size_t end = vertices_.size ();
    for (; begin < end; ++begin)
      for (const pcl::index_t* w = graph_.begin (vertices_[begin]); w != graph_.end (vertices_[begin]); ++w)
        if (hops_[*w] == OUTSIDE) {
          hops_[*w] = hops;
          vertices_.push_back (*w);
        }
    // What has no vertices beyond it is the whole of a surface that may be closed.
    if (vertices_.size () == end)
      break;
    if ((most - hops) % BAND != 0)
      continue;
    if (hops > least && !hangsTogether (band, vertices_.size (), hops))
      break;
    radius = hops;
    band = vertices_.size ();
    if (hops >= most)
      break;
  }
  for (const pcl::index_t v : vertices_)
    hops_[v] = OUTSIDE;
  return radius;
}

bool
HopRings::hangsTogether (std::size_t begin, std::size_t end, int hops)
{
  const std::size_t fewest = std::max (FEWEST_VERTICES, (end - begin + SMALLEST_SHARE - 1) / SMALLEST_SHARE);
  const int inner = std::max (hops - BAND, 0); // the center is no ring
  const auto isInBand = [&] (pcl::index_t v) { return hops_[v] > inner && hops_[v] <= hops; };
  int parts = 0;
  for (std::size_t i = begin; i < end; ++i) {
    if (!isInBand (vertices_[i]))
      continue;
    std::size_t size = 0;
    const auto visit = [&] (pcl::index_t v) {
      hops_[v] += COUNTED;
      stack_.push_back (v);
    };
    for (visit (vertices_[i]); !stack_.empty (); ++size) {
      const pcl::index_t v = stack_.back ();
      stack_.pop_back ();
      for (const pcl::index_t* w = graph_.begin (v); w != graph_.end (v); ++w)
        if (isInBand (*w))
          visit (*w);
    }
    parts += size >= fewest ? 1 : 0;
  }
  for (std::size_t i = begin; i < end; ++i)
    hops_[vertices_[i]] -= COUNTED;
  return parts <= 1;
}

} // namespace manifold
} // namespace pcl
