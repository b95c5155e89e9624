#pragma once

#include "oracle_graph.h"

#include <pcl/manifold/graph_faces.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace oracle {

using pcl::manifold::LandmarkMesh;
using Walk = std::vector<index_t>;

inline LandmarkMesh::Edge
sideOf (const Walk& walk, std::size_t i)
{
  const auto [low, high] = std::minmax (walk[i], walk[(i + 1) % walk.size ()]);
  return {low, high};
}

/** \brief How often each edge is a side of some walks. */
inline std::map<LandmarkMesh::Edge, int>
countSides (const std::vector<Walk>& walks)
{
  std::map<LandmarkMesh::Edge, int> counts;
  for (const Walk& walk : walks)
    for (std::size_t i = 0; i < walk.size (); ++i)
      ++counts[sideOf (walk, i)];
  return counts;
}

/** \brief Walks as sets do not know where they begin and in which direction they go. */
inline Walk
normalized (Walk walk)
{
  std::rotate (walk.begin (), std::min_element (walk.begin (), walk.end ()), walk.end ());
  if (walk.size () > 2 && walk[1] > walk.back ())
    std::reverse (walk.begin () + 1, walk.end ());
  return walk;
}

inline std::multiset<Walk>
normalizedAll (const std::vector<Walk>& walks)
{
  std::multiset<Walk> result;
  for (const Walk& walk : walks)
    result.insert (normalized (walk));
  return result;
}

/** \brief The number of parts that some edges make of n vertices. */
inline int
countParts (std::size_t n, const std::vector<LandmarkMesh::Edge>& edges)
{
  EdgeSet set;
  for (const auto& edge : edges)
    set.emplace (edge[0], edge[1]);
  const Hops hops = hopsBetweenAll (graphOfEdges (static_cast<int> (n), set));
  int parts = 0;
  for (std::size_t v = 0; v < n; ++v)
    parts += std::none_of (hops[v].begin (), hops[v].begin () + static_cast<std::ptrdiff_t> (v),
                           [] (int h) { return h < UNREACHABLE; })
               ? 1
               : 0;
  return parts;
}

/** \brief What must be true of any mesh of landmarks, whatever it was made from.
 * \param[in] has_holes does the rule notice them? */
inline void
expectSound (const LandmarkMesh& mesh, const std::vector<TileContact>& contacts, std::size_t landmarks,
             int maximum_length, bool has_holes, const std::string& name)
{
  std::set<LandmarkMesh::Edge> touching;
  std::vector<LandmarkMesh::Edge> adjacent;
  for (const TileContact& contact : contacts) {
    touching.insert ({contact.first, contact.second});
    if (contact.adjacent)
      adjacent.push_back ({contact.first, contact.second});
  }
  ASSERT_TRUE (std::is_sorted (mesh.edges.begin (), mesh.edges.end ())) << name;
  ASSERT_EQ (std::adjacent_find (mesh.edges.begin (), mesh.edges.end ()), mesh.edges.end ()) << name;
  for (const auto& edge : mesh.edges)
    ASSERT_TRUE (touching.count (edge) == 1) << name << ": " << edge[0] << ", " << edge[1];
  for (const Walk& face : mesh.faces) {
    ASSERT_GE (face.size (), 3u) << name;
    ASSERT_LE (face.size (), static_cast<std::size_t> (std::max (3, maximum_length))) << name;
  }
  const auto faces_of = countSides (mesh.faces);
  const auto holes_of = countSides (mesh.holes);
  for (const auto* counts : {&faces_of, &holes_of})
    for (const auto& [edge, count] : *counts) {
      ASSERT_TRUE (std::binary_search (mesh.edges.begin (), mesh.edges.end (), edge)) << name;
      ASSERT_LE (count, 2) << name << ": " << edge[0] << ", " << edge[1];
    }
  const auto countIn = [] (const auto& counts, const LandmarkMesh::Edge& edge) {
    const auto found = counts.find (edge);
    return found == counts.end () ? 0 : found->second;
  };
  // Curves have no sides, and holes end at faces.
  for (const auto& edge : mesh.edges)
    if (const int faces = countIn (faces_of, edge); faces > 0) {
      ASSERT_EQ (faces + (has_holes ? countIn (holes_of, edge) : 2 - faces), 2)
        << name << ": " << edge[0] << ", " << edge[1];
    }
  for (const Walk& hole : mesh.holes) {
    bool at_face = false;
    for (std::size_t i = 0; i < hole.size (); ++i)
      at_face = at_face || countIn (faces_of, sideOf (hole, i)) > 0;
    ASSERT_TRUE (at_face) << name;
  }
  ASSERT_EQ (countParts (landmarks, mesh.edges), countParts (landmarks, adjacent)) << name;
}

} // namespace oracle
