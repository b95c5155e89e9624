#pragma once

#include "oracle_random.h"

#include <pcl/manifold/graph_voronoi.h>

#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

/** What the stages of GraphReconstruction must find, by their definitions, from the hops between all pairs of
 * vertices. */
namespace oracle {

using pcl::index_t;
using pcl::manifold::NeighborhoodGraph;
using pcl::manifold::TileContact;

using EdgeSet = std::set<std::pair<index_t, index_t>>;

inline NeighborhoodGraph
graphOfRows (const std::vector<std::vector<index_t>>& rows)
{
  NeighborhoodGraph graph;
  graph.offsets.push_back (0);
  for (const std::vector<index_t>& row : rows) {
    graph.neighbors.insert (graph.neighbors.end (), row.begin (), row.end ());
    graph.offsets.push_back (graph.neighbors.size ());
  }
  return graph;
}

/** \brief The proper graph of n vertices with these edges, taken both ways and without self loops. */
inline NeighborhoodGraph
graphOfEdges (int n, const EdgeSet& edges)
{
  std::vector<std::set<index_t>> rows (static_cast<std::size_t> (n));
  for (const auto& [v, w] : edges)
    if (v != w) {
      rows[static_cast<std::size_t> (v)].insert (w);
      rows[static_cast<std::size_t> (w)].insert (v);
    }
  std::vector<std::vector<index_t>> sorted;
  for (const std::set<index_t>& row : rows)
    sorted.emplace_back (row.begin (), row.end ());
  return graphOfRows (sorted);
}

constexpr int UNREACHABLE = 1 << 30;

/** \brief Per pair of vertices the hops between them. */
using Hops = std::vector<std::vector<int>>;

inline Hops
hopsBetweenAll (const NeighborhoodGraph& graph)
{
  const auto n = static_cast<std::size_t> (graph.size ());
  Hops hops (n, std::vector<int> (n, UNREACHABLE));
  for (std::size_t start = 0; start < n; ++start) {
    std::vector<std::size_t> queue{start};
    hops[start][start] = 0;
    for (std::size_t i = 0; i < queue.size (); ++i) {
      const auto v = static_cast<index_t> (queue[i]);
      for (const index_t* w = graph.begin (v); w != graph.end (v); ++w)
        if (hops[start][static_cast<std::size_t> (*w)] == UNREACHABLE) {
          hops[start][static_cast<std::size_t> (*w)] = hops[start][queue[i]] + 1;
          queue.push_back (static_cast<std::size_t> (*w));
        }
    }
  }
  return hops;
}

/** \brief Takes the vertices in an order, each that is at least k hops from all that were taken. */
inline std::vector<index_t>
stableSetInOrder (const Hops& hops, int k, const std::vector<index_t>& order)
{
  std::vector<index_t> taken;
  for (const index_t v : order)
    if (std::all_of (taken.begin (), taken.end (), [&] (index_t w) {
          return hops[static_cast<std::size_t> (v)][static_cast<std::size_t> (w)] >= k;
        }))
      taken.push_back (v);
  std::sort (taken.begin (), taken.end ());
  return taken;
}

inline std::vector<index_t>
tilesByHops (const Hops& hops, const std::vector<index_t>& landmarks)
{
  std::vector<index_t> tiles;
  for (const std::vector<int>& from : hops) {
    int nearest = UNREACHABLE;
    index_t tile = -1;
    for (std::size_t i = 0; i < landmarks.size (); ++i)
      if (from[static_cast<std::size_t> (landmarks[i])] < nearest) {
        nearest = from[static_cast<std::size_t> (landmarks[i])];
        tile = static_cast<index_t> (i);
      }
    tiles.push_back (tile);
  }
  return tiles;
}

/** \brief Is there a path between two landmarks all of whose vertices are at least two hops from every tile
 * but theirs? */
inline bool
hasClearPath (const NeighborhoodGraph& graph, const Hops& hops, const std::vector<index_t>& landmarks,
              const std::vector<index_t>& tiles, index_t first, index_t second)
{
  const std::size_t n = tiles.size ();
  EdgeSet edges;
  std::vector<bool> clear (n, true);
  for (std::size_t v = 0; v < n; ++v)
    for (std::size_t w = 0; w < n; ++w)
      if (tiles[w] >= 0 && tiles[w] != first && tiles[w] != second && hops[v][w] < 2)
        clear[v] = false;
  for (std::size_t i = 0; i < n; ++i) {
    const auto v = static_cast<index_t> (i);
    for (const index_t* w = graph.begin (v); w != graph.end (v); ++w)
      if (clear[i] && clear[static_cast<std::size_t> (*w)])
        edges.emplace (v, *w);
  }
  const auto from = static_cast<std::size_t> (landmarks[static_cast<std::size_t> (first)]);
  const auto to = static_cast<std::size_t> (landmarks[static_cast<std::size_t> (second)]);
  return clear[from] && clear[to] &&
         hopsBetweenAll (graphOfEdges (static_cast<int> (n), edges))[from][to] < UNREACHABLE;
}

/** \brief The contacts, with no rule applied. */
inline std::vector<TileContact>
contactsByPairs (const NeighborhoodGraph& graph, const std::vector<index_t>& tiles)
{
  std::map<std::pair<index_t, index_t>, std::set<index_t>> points;
  std::map<std::pair<index_t, index_t>, EdgeSet> edges;
  for (index_t v = 0; v < graph.size (); ++v)
    for (const index_t* w = graph.begin (v); w != graph.end (v); ++w) {
      const auto pair =
        std::minmax (tiles[static_cast<std::size_t> (v)], tiles[static_cast<std::size_t> (*w)]);
      if (pair.first == pair.second)
        continue;
      points[pair].insert (v);
      edges[pair].insert (std::minmax (v, *w));
    }
  std::vector<TileContact> contacts;
  for (const auto& [pair, at] : points) {
    contacts.emplace_back ();
    contacts.back ().first = pair.first;
    contacts.back ().second = pair.second;
    contacts.back ().boundary_points = static_cast<std::int32_t> (at.size ());
    contacts.back ().linking_edges = static_cast<std::int32_t> (edges[pair].size ());
  }
  return contacts;
}

} // namespace oracle
