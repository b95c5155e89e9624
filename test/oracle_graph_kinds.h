#pragma once

#include "oracle_graph.h"
#include "oracle_points.h"

namespace oracle {

/** \brief Graphs on which stages go wrong first, and such as GraphReconstruction meets. */
struct NamedGraph
{
  std::string name;
  std::function<EdgeSet (int, Random&)> edges;
};

inline EdgeSet
randomEdges (int n, int count, Random& random)
{
  EdgeSet edges;
  for (int i = 0; i < count; ++i)
    edges.emplace (random.index (n), random.index (n));
  return edges;
}

inline EdgeSet
pathOf (int n)
{
  EdgeSet edges;
  for (int v = 1; v < n; ++v)
    edges.emplace (v - 1, v);
  return edges;
}

inline EdgeSet
gridEdges (int n, int width, bool diagonals)
{
  EdgeSet edges;
  for (int v = 0; v < n; ++v) {
    if (v % width != 0)
      edges.emplace (v - 1, v);
    if (v >= width)
      edges.emplace (v - width, v);
    if (diagonals && v >= width && v % width != 0)
      edges.emplace (v - width - 1, v);
  }
  return edges;
}

inline EdgeSet
edgesOf (const NeighborhoodGraph& graph)
{
  EdgeSet edges;
  for (index_t v = 0; v < graph.size (); ++v)
    for (const index_t* w = graph.begin (v); w != graph.end (v); ++w)
      edges.emplace (v, *w);
  return edges;
}

inline const std::vector<NamedGraph>&
namedGraphs ()
{
  static const std::vector<NamedGraph> graphs{
    {"isolated vertices", [] (int, Random&) { return EdgeSet (); }},
    {"path", [] (int n, Random&) { return pathOf (n); }},
    {"cycle",
     [] (int n, Random&) {
       EdgeSet edges = pathOf (n);
       edges.emplace (0, n - 1);
       return edges;
     }},
    {"star",
     [] (int n, Random&) {
       EdgeSet edges;
       for (int v = 1; v < n; ++v)
         edges.emplace (0, v);
       return edges;
     }},
    {"complete",
     [] (int n, Random&) {
       EdgeSet edges;
       for (int v = 0; v < n; ++v)
         for (int w = 0; w < v; ++w)
           edges.emplace (w, v);
       return edges;
     }},
    {"tree",
     [] (int n, Random& random) {
       EdgeSet edges;
       for (int v = 1; v < n; ++v)
         edges.emplace (random.index (v), v);
       return edges;
     }},
    {"grid", [] (int n, Random& random) { return gridEdges (n, random.integer (2, 12), false); }},
    {"grid with diagonals",
     [] (int n, Random& random) { return gridEdges (n, random.integer (2, 12), true); }},
    {"few edges", [] (int n, Random& random) { return randomEdges (n, random.integer (0, n), random); }},
    {"many edges", [] (int n, Random& random) { return randomEdges (n, random.integer (n, 4 * n), random); }},
    {"two parts",
     [] (int n, Random& random) {
       EdgeSet edges;
       for (const auto& [v, w] : randomEdges (n, 3 * n, random))
         if (v % 2 == w % 2)
           edges.emplace (v, w);
       return edges;
     }},
    {"nearest neighbours",
     [] (int n, Random& random) {
       const Eigen::MatrixXd points = randomPoints (random.integer (1, 4), n, random);
       return edgesOf (nearestByLookingAtAll (points, random.integer (1, 8)));
     }},
  };
  return graphs;
}

/** \brief Calls body (graph, name) for graphs of every kind, the smallest first. */
template <typename Body>
void
forEachGraph (int rounds, int largest, const Body& body)
{
  body (NeighborhoodGraph (), "no offsets");
  body (graphOfEdges (0, {}), "no vertex");
  for (int round = 0; round < rounds; ++round) {
    Random random (static_cast<std::uint64_t> (round) + 500);
    for (const NamedGraph& named : namedGraphs ()) {
      const int n = round < 4 ? round + 1 : random.integer (5, largest);
      body (graphOfEdges (n, named.edges (n, random)), named.name + ", round " + std::to_string (round));
    }
  }
}

/** \brief Points like those of a surface with noise, as a graph large enough for several threads to share. */
inline NeighborhoodGraph
largeGraph ()
{
  Random random (77);
  Eigen::MatrixXd points (3, 40000);
  for (Eigen::Index i = 0; i < points.cols (); ++i)
    points.col (i) << random.uniform (), random.uniform (), 0.01 * random.uniform ();
  NeighborhoodGraph graph;
  pcl::manifold::nearestNeighborGraph (points, 10, 1, graph);
  return graph;
}

} // namespace oracle
