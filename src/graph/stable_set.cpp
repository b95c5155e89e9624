#include <pcl/manifold/graph_voronoi.h>

#include "common/parallel.h"
#include "graph/priority.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <limits>

namespace pcl {
namespace manifold {

namespace {

// As many hops as vertices are away from which no landmark is known in less than the hops that are asked for.
constexpr int UNREACHED = std::numeric_limits<int>::max ();

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

// The vertices that are nearer to a candidate than to all landmarks, by their hops from it.
struct Ball
{
  std::vector<pcl::index_t> vertices;
  std::vector<std::size_t> ends; ///< those at a number of hops end before vertices[ends[hops]]
};

// Searches less than `hops` hops around a vertex.
//
// It need not go on from where a landmark is as near: whatever lies behind is as near to that one, too. So it
// gets smaller the more landmarks there are around it.
void
findBall (const NeighborhoodGraph& graph, const std::vector<int>& hops_to_landmark, pcl::index_t center,
          int hops, std::vector<std::uint8_t>& seen, Ball& ball)
{
  ball.vertices.assign (1, center);
  ball.ends.assign (1, 1);
  seen[center] = 1;
  std::size_t next = 0;
  for (int hop = 1; hop < hops && next < ball.vertices.size (); ++hop) {
    for (const std::size_t end = ball.vertices.size (); next < end; ++next) {
      const pcl::index_t v = ball.vertices[next];
      for (const pcl::index_t* w = graph.begin (v); w != graph.end (v); ++w)
        if (!seen[*w] && hops_to_landmark[*w] > hop) {
          seen[*w] = 1;
          ball.vertices.push_back (*w);
        }
    }
    ball.ends.push_back (ball.vertices.size ());
  }
  for (const pcl::index_t v : ball.vertices)
    seen[v] = 0;
}

void
addLandmark (const Ball& ball, std::vector<int>& hops_to_landmark)
{
  std::size_t i = 0;
  for (std::size_t hop = 0; hop < ball.ends.size (); ++hop)
    for (; i < ball.ends[hop]; ++i)
      hops_to_landmark[ball.vertices[i]] =
        std::min (hops_to_landmark[ball.vertices[i]], static_cast<int> (hop));
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
    std::vector<int> hops_to_landmark (n, UNREACHED);
    tbb::enumerable_thread_specific<std::vector<std::uint8_t>> seen (n, std::uint8_t (0));
    std::vector<pcl::index_t> block;
    std::vector<Ball> balls (blockSize (n));
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
