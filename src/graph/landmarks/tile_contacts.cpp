#include <pcl/manifold/graph_voronoi.h>

#include "common/parallel.h"
#include "graph/landmarks/clear_path.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <unordered_map>

namespace pcl {
namespace manifold {

namespace {

// Tiles of vertices that follow each other are few: the table of a piece stays small.
constexpr std::size_t VERTICES_PER_PIECE = 4096;

// What some vertices see of the contact of two tiles.
struct ContactCount
{
  pcl::index_t first;
  pcl::index_t second;
  std::int32_t boundary_points;
  std::int32_t edge_ends;
};

// The contacts that the vertices of a piece see.
class ContactTable
{
public:
  // Counts an edge from a vertex to one of another tile. All edges of a vertex follow each other.
  void addEdge (pcl::index_t vertex, pcl::index_t tile, pcl::index_t other_tile)
  {
    const pcl::index_t first = std::min (tile, other_tile);
    const pcl::index_t second = std::max (tile, other_tile);
    // Vertices often have several neighbours in a row in the same tile.
    if (!last_ || last_->count.first != first || last_->count.second != second) {
      last_ = &entries_[static_cast<std::uint64_t> (first) << 32 | static_cast<std::uint64_t> (second)];
      last_->count.first = first;
      last_->count.second = second;
    }
    ++last_->count.edge_ends;
    last_->count.boundary_points += last_->last_vertex != vertex ? 1 : 0;
    last_->last_vertex = vertex;
  }

  void appendTo (std::vector<ContactCount>& counts) const
  {
    for (const auto& [pair, entry] : entries_)
      counts.push_back (entry.count);
  }

private:
  struct Entry
  {
    ContactCount count = {};
    pcl::index_t last_vertex = -1;
  };

  std::unordered_map<std::uint64_t, Entry> entries_;
  Entry* last_ = nullptr;
};

bool
isBefore (const ContactCount& a, const ContactCount& b)
{
  return a.first != b.first ? a.first < b.first : a.second < b.second;
}

// What the vertices of pieces see of the contacts, in any order.
std::vector<ContactCount>
countByPieces (const NeighborhoodGraph& graph, const std::vector<pcl::index_t>& tiles)
{
  tbb::enumerable_thread_specific<std::vector<ContactCount>> found;
  parallelRanges (
    tiles.size (),
    [&] (std::size_t begin, std::size_t end) {
      ContactTable table;
      for (std::size_t i = begin; i < end; ++i) {
        const auto v = static_cast<pcl::index_t> (i);
        for (const pcl::index_t* w = graph.begin (v); w != graph.end (v); ++w)
          if (tiles[*w] != tiles[i])
            table.addEdge (v, tiles[i], tiles[*w]);
      }
      table.appendTo (found.local ());
    },
    VERTICES_PER_PIECE);
  std::vector<ContactCount> counts;
  for (const std::vector<ContactCount>& of_thread : found)
    counts.insert (counts.end (), of_thread.begin (), of_thread.end ());
  return counts;
}

// Adds up what pieces have counted.
std::vector<TileContact>
sumByPairs (std::vector<ContactCount> counts)
{
  tbb::parallel_sort (counts.begin (), counts.end (), isBefore);
  std::vector<TileContact> contacts;
  for (const ContactCount& count : counts) {
    if (contacts.empty () || contacts.back ().first != count.first ||
        contacts.back ().second != count.second) {
      contacts.emplace_back ();
      contacts.back ().first = count.first;
      contacts.back ().second = count.second;
    }
    contacts.back ().boundary_points += count.boundary_points;
    contacts.back ().linking_edges += count.edge_ends;
  }
  for (TileContact& contact : contacts)
    contact.linking_edges /= 2; // every edge was seen from both of its ends
  return contacts;
}

} // namespace

std::vector<TileContact>
tileContacts (const NeighborhoodGraph& graph, const std::vector<pcl::index_t>& landmarks,
              const std::vector<pcl::index_t>& tiles, AdjacencyRule rule, int threshold, unsigned int threads)
{
  std::vector<TileContact> contacts;
  withThreads (threads, [&] {
    contacts = sumByPairs (countByPieces (graph, tiles));
    if (rule == AdjacencyRule::CLEAR_PATH)
      findClearPaths (graph, landmarks, tiles, contacts);
  });
  for (TileContact& contact : contacts)
    if (rule == AdjacencyRule::BOUNDARY_POINTS)
      contact.adjacent = contact.boundary_points > threshold;
    else if (rule == AdjacencyRule::LINKING_EDGES)
      contact.adjacent = contact.linking_edges > threshold;
  return contacts;
}

} // namespace manifold
} // namespace pcl
