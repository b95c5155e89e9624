#include "complex/disjoint_sets.h"
#include "complex/topology_parts.h"
#include "complex/vertex_numbering.h"

#include <algorithm>
#include <cstdint>

namespace pcl {
namespace manifold {

namespace {

/** \brief Drops the edges that are none and sorts the ends of the others, which keep their order. */
std::vector<SimplicialComplex::Edge>
properEdges (const std::vector<SimplicialComplex::Edge>& edges)
{
  std::vector<SimplicialComplex::Edge> proper;
  proper.reserve (edges.size ());
  for (const auto& [a, b] : edges)
    if (a >= 0 && b >= 0 && a != b)
      proper.push_back ({std::min (a, b), std::max (a, b)});
  return proper;
}

std::size_t
countDuplicates (std::vector<SimplicialComplex::Edge> edges)
{
  std::sort (edges.begin (), edges.end ());
  return static_cast<std::size_t> (edges.end () - std::unique (edges.begin (), edges.end ()));
}

} // namespace

CurveTopology
analyzeCurve (const std::vector<SimplicialComplex::Edge>& edges)
{
  const std::vector<SimplicialComplex::Edge> proper = properEdges (edges);
  const VertexNumbering numbering ({proper});
  CurveTopology total;
  total.edges = proper.size ();
  total.vertices = numbering.size ();
  total.degenerate_edges = edges.size () - proper.size ();
  total.duplicate_edges = countDuplicates (proper);

  // Sets of edges and not of vertices, so that components are numbered by their first edges.
  DisjointSets sets (proper.size ());
  std::vector<std::uint32_t> first_edge (numbering.size ());
  std::vector<std::size_t> degrees (numbering.size (), 0);
  for (std::uint32_t e = 0; e < proper.size (); ++e)
    for (const pcl::index_t v : proper[e]) {
      const std::uint32_t vertex = numbering[v];
      if (++degrees[vertex] == 1)
        first_edge[vertex] = e;
      sets.join (first_edge[vertex], e);
    }
  std::vector<std::uint32_t> component_of;
  total.components.resize (sets.number (component_of));

  for (const std::uint32_t component : component_of)
    ++total.components[component].edges;
  for (std::size_t v = 0; v < degrees.size (); ++v) {
    CurveComponent& component = total.components[component_of[first_edge[v]]];
    ++component.vertices;
    component.end_vertices += degrees[v] == 1;
    component.branching_vertices += degrees[v] > 2;
  }
  for (CurveComponent& component : total.components) {
    component.closed = component.end_vertices == 0 && component.branching_vertices == 0;
    total.end_vertices += component.end_vertices;
    total.branching_vertices += component.branching_vertices;
  }
  std::stable_sort (total.components.begin (), total.components.end (),
                    [] (const CurveComponent& a, const CurveComponent& b) { return a.edges > b.edges; });
  return total;
}

} // namespace manifold
} // namespace pcl
