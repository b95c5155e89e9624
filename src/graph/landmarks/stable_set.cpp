#include <pcl/manifold/graph_voronoi.h>

#include "common/large_pages.h"
#include "common/parallel.h"
#include "graph/landmarks/landmark_balls.h"
#include "graph/landmarks/priority.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_sort.h>

#include <algorithm>

namespace pcl {
namespace manifold {

namespace {

// Vertices are sorted in four parts: those whose priority is in the lowest 1/64, 1/16, 1/4 and the others.
// When a part is sorted, most of its vertices are excluded already and need not be.
constexpr int PARTS = 4;

int
partOf (std::uint64_t priority)
{
  return (priority >> 58 != 0) + (priority >> 60 != 0) + (priority >> 62 != 0);
}

// The vertices of a part that may still become landmarks, in the order of priority.
std::vector<pcl::index_t>
freeVertices (const std::vector<int>& hops_to_landmark, std::uint64_t seed, int part)
{
  using Key = std::pair<std::uint64_t, pcl::index_t>;
  tbb::enumerable_thread_specific<std::vector<Key>> found;
  parallelRanges (hops_to_landmark.size (), [&] (std::size_t begin, std::size_t end) {
    std::vector<Key>& keys = found.local ();
    for (std::size_t i = begin; i < end; ++i)
      if (hops_to_landmark[i] == UNREACHED) {
        const auto v = static_cast<pcl::index_t> (i);
        const std::uint64_t priority = priorityOf (v, seed);
        if (partOf (priority) == part)
          keys.emplace_back (priority, v);
      }
  });
  std::vector<Key> all;
  for (const std::vector<Key>& keys : found)
    all.insert (all.end (), keys.begin (), keys.end ());
  tbb::parallel_sort (all.begin (), all.end ());
  std::vector<pcl::index_t> vertices (all.size ());
  std::transform (all.begin (), all.end (), vertices.begin (), [] (const Key& key) { return key.second; });
  return vertices;
}

// How many candidates are searched around at the same time. Those that turn out to be near an earlier one are
// work for nothing, so there are few in small graphs.
std::size_t
blockSize (std::size_t vertices)
{
  const auto threads = static_cast<std::size_t> (tbb::this_task_arena::max_concurrency ());
  return threads == 1 ? 1 : std::min (16 * threads, vertices / 2048 + 1);
}

} // namespace

std::vector<pcl::index_t>
maximalStableSet (const NeighborhoodGraph& graph, int hops, std::uint64_t seed, unsigned int threads)
{
  const auto n = static_cast<std::size_t> (graph.size ());
  std::vector<pcl::index_t> landmarks;
  withThreads (threads, [&] {
    std::vector<int> hops_to_landmark;
    assignLarge (hops_to_landmark, n, UNREACHED);
    tbb::enumerable_thread_specific<std::vector<std::uint8_t>> seen (n, std::uint8_t (0));
    std::vector<pcl::index_t> block;
    std::vector<LandmarkBall> balls (blockSize (n));
    for (int part = 0; part < PARTS; ++part) {
      const std::vector<pcl::index_t> candidates = freeVertices (hops_to_landmark, seed, part);
      auto next = candidates.begin ();
      while (next != candidates.end ()) {
        block.clear ();
        for (; next != candidates.end () && block.size () < balls.size (); ++next)
          if (hops_to_landmark[*next] == UNREACHED)
            block.push_back (*next);
        parallelFor (
          block.size (),
          [&] (std::size_t i) {
            findBall (graph, hops_to_landmark, block[i], hops, seen.local (), balls[i]);
          },
          1);
        for (std::size_t i = 0; i < block.size (); ++i)
          if (hops_to_landmark[block[i]] == UNREACHED) {
            addLandmark (balls[i], hops_to_landmark);
            landmarks.push_back (block[i]);
          }
      }
    }
  });
  std::sort (landmarks.begin (), landmarks.end ());
  return landmarks;
}

} // namespace manifold
} // namespace pcl
