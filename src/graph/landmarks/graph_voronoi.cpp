#include <pcl/manifold/graph_voronoi.h>

#include "common/large_pages.h"
#include "common/parallel.h"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>

namespace pcl {
namespace manifold {

namespace {

constexpr pcl::index_t NO_TILE = -1;

// From this share of the vertices on, a level is spread by looking from all others for neighbours in it: in
// parallel, and, as there can be no more such levels than this, still in linear time.
constexpr std::size_t LARGE_LEVEL = 16;

struct Assignment
{
  pcl::index_t vertex;
  pcl::index_t tile;
};

// Gives the neighbours of a level that have no tile yet to the tile of the first vertex that has them for
// neighbours, and makes them the level. If it was in the order of the tiles, this is the smallest tile of the
// level around them, and they are in that order as well.
void
push (const NeighborhoodGraph& graph, std::vector<pcl::index_t>& tiles, std::vector<pcl::index_t>& level)
{
  std::vector<pcl::index_t> next;
  for (const pcl::index_t v : level)
    for (const pcl::index_t* w = graph.begin (v); w != graph.end (v); ++w)
      if (tiles[*w] == NO_TILE) {
        tiles[*w] = tiles[v];
        next.push_back (*w);
      }
  level = std::move (next);
}

// The same from the other side, in parallel. All vertices that have a tile and a neighbour without are of the
// last level, or that neighbour had got a tile before.
void
pull (const NeighborhoodGraph& graph, std::vector<pcl::index_t>& tiles, std::vector<pcl::index_t>& level)
{
  tbb::enumerable_thread_specific<std::vector<Assignment>> found;
  parallelRanges (tiles.size (), [&] (std::size_t begin, std::size_t end) {
    std::vector<Assignment>& assignments = found.local ();
    for (std::size_t i = begin; i < end; ++i) {
      if (tiles[i] != NO_TILE)
        continue;
      const auto v = static_cast<pcl::index_t> (i);
      pcl::uindex_t smallest = NO_TILE;
      for (const pcl::index_t* w = graph.begin (v); w != graph.end (v); ++w)
        smallest = std::min (smallest, static_cast<pcl::uindex_t> (tiles[*w]));
      if (static_cast<pcl::index_t> (smallest) != NO_TILE)
        assignments.push_back ({v, static_cast<pcl::index_t> (smallest)});
    }
  });
  level.clear ();
  for (const std::vector<Assignment>& assignments : found)
    for (const Assignment& assignment : assignments) {
      tiles[assignment.vertex] = assignment.tile;
      level.push_back (assignment.vertex);
    }
}

} // namespace

// Vertices are reached level by level, a level being those at the same number of hops from the landmarks. The
// nearest landmarks of a vertex are those of its neighbours in the level before: whose tile it gets is the
// smallest of the tiles of these, as each of them has the smallest of its own.
std::vector<pcl::index_t>
graphVoronoiDiagram (const NeighborhoodGraph& graph, const std::vector<pcl::index_t>& landmarks,
                     unsigned int threads)
{
  const auto n = static_cast<std::size_t> (graph.size ());
  std::vector<pcl::index_t> tiles;
  assignLarge (tiles, n, NO_TILE);
  for (std::size_t i = 0; i < landmarks.size (); ++i)
    tiles[landmarks[i]] = static_cast<pcl::index_t> (i);
  std::vector<pcl::index_t> level = landmarks;
  withThreads (threads, [&] {
    bool in_order = true;
    while (!level.empty ()) {
      if (level.size () >= n / LARGE_LEVEL) {
        pull (graph, tiles, level);
        in_order = false;
        continue;
      }
      if (!in_order)
        std::sort (level.begin (), level.end (),
                   [&tiles] (pcl::index_t v, pcl::index_t w) { return tiles[v] < tiles[w]; });
      in_order = true;
      push (graph, tiles, level);
    }
  });
  return tiles;
}

} // namespace manifold
} // namespace pcl
