#include "graph/clear_path.h"

#include "common/parallel.h"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <cstdint>

namespace pcl {
namespace manifold {

namespace {

// What tile besides its own a vertex has neighbours in.
constexpr pcl::index_t NONE = -1;
constexpr pcl::index_t SEVERAL = -2;

constexpr std::size_t CONTACTS_PER_TASK = 64;

std::vector<pcl::index_t>
otherTiles (const NeighborhoodGraph& graph, const std::vector<pcl::index_t>& tiles)
{
  std::vector<pcl::index_t> others (tiles.size ());
  parallelFor (tiles.size (), [&] (std::size_t i) {
    const auto v = static_cast<pcl::index_t> (i);
    pcl::index_t other = NONE;
    for (const pcl::index_t* w = graph.begin (v); w != graph.end (v); ++w)
      if (tiles[*w] != tiles[v] && tiles[*w] != other)
        other = other == NONE ? tiles[*w] : SEVERAL;
    others[i] = other;
  });
  return others;
}

struct Scratch
{
  std::vector<std::uint32_t> seen_in; // per vertex one more than the last contact that saw it
  std::vector<pcl::index_t> stack;
};

} // namespace

void
findClearPaths (const NeighborhoodGraph& graph, const std::vector<pcl::index_t>& landmarks,
                const std::vector<pcl::index_t>& tiles, std::vector<TileContact>& contacts)
{
  const std::vector<pcl::index_t> others = otherTiles (graph, tiles);
  tbb::enumerable_thread_specific<Scratch> scratches;
  const auto search = [&] (std::size_t begin, std::size_t end) {
    Scratch& scratch = scratches.local ();
    scratch.seen_in.resize (tiles.size (), 0);
    for (std::size_t i = begin; i < end; ++i) {
      TileContact& contact = contacts[i];
      const auto search_number = static_cast<std::uint32_t> (i + 1);
      const auto visit = [&] (pcl::index_t v) {
        const bool clear =
          (tiles[v] == contact.first && (others[v] == NONE || others[v] == contact.second)) ||
          (tiles[v] == contact.second && (others[v] == NONE || others[v] == contact.first));
        if (!clear || scratch.seen_in[v] == search_number)
          return;
        scratch.seen_in[v] = search_number;
        scratch.stack.push_back (v);
      };
      const pcl::index_t goal = landmarks[contact.second];
      visit (landmarks[contact.first]);
      while (!scratch.stack.empty () && scratch.seen_in[goal] != search_number) {
        const pcl::index_t v = scratch.stack.back ();
        scratch.stack.pop_back ();
        std::for_each (graph.begin (v), graph.end (v), visit);
      }
      scratch.stack.clear ();
      contact.adjacent = scratch.seen_in[goal] == search_number;
    }
  };
  parallelRanges (contacts.size (), search, CONTACTS_PER_TASK);
}

} // namespace manifold
} // namespace pcl
