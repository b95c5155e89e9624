#pragma once

#include <pcl/manifold/topology_report.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace oracle {

using pcl::manifold::SurfaceComponent;
using Edge = pcl::SimplicialComplex::Edge;
using Triangle = pcl::SimplicialComplex::Triangle;

/** \brief The same numbers by plain counting over maps, for few triangles. */
class Surface
{
public:
  explicit Surface (std::vector<Triangle> triangles) : triangles_ (std::move (triangles))
  {
    for (std::size_t f = 0; f < triangles_.size (); ++f)
      for (int i = 0; i < 3; ++i)
        uses_[key (triangles_[f][i], triangles_[f][(i + 1) % 3])].push_back (f);
    component_.assign (triangles_.size (), -1);
    for (std::size_t f = 0; f < triangles_.size (); ++f)
      if (component_[f] < 0)
        flood (f, components_++);
  }

  std::vector<SurfaceComponent> components () const
  {
    std::vector<SurfaceComponent> result (static_cast<std::size_t> (components_));
    std::vector<std::set<int>> vertices (result.size ());
    for (std::size_t f = 0; f < triangles_.size (); ++f) {
      ++result[static_cast<std::size_t> (component_[f])].faces;
      vertices[static_cast<std::size_t> (component_[f])].insert (triangles_[f].begin (),
                                                                 triangles_[f].end ());
    }
    for (const auto& [edge, faces] : uses_) {
      SurfaceComponent& c = result[static_cast<std::size_t> (component_[faces[0]])];
      ++c.edges;
      ++(faces.size () == 1 ? c.boundary_edges : faces.size () == 2 ? c.inner_edges : c.non_manifold_edges);
    }
    for (std::size_t i = 0; i < result.size (); ++i) {
      SurfaceComponent& c = result[i];
      c.vertices = vertices[i].size ();
      for (const int v : vertices[i])
        c.non_manifold_vertices += !isManifold (v);
      c.euler_characteristic =
        static_cast<int> (c.vertices) - static_cast<int> (c.edges) + static_cast<int> (c.faces);
      c.closed = c.boundary_edges == 0;
      c.orientable = isOrientable (static_cast<int> (i));
      c.boundary_loops = loops (static_cast<int> (i));
    }
    std::stable_sort (result.begin (), result.end (),
                      [] (const auto& a, const auto& b) { return a.faces > b.faces; });
    return result;
  }

  bool isManifold (int vertex) const
  {
    std::map<int, std::vector<int>> link = linkOf (vertex);
    std::set<int> reached = {link.begin ()->first};
    std::vector<int> open = {link.begin ()->first};
    while (!open.empty ()) {
      const int v = open.back ();
      open.pop_back ();
      for (const int w : link[v])
        if (reached.insert (w).second)
          open.push_back (w);
    }
    return reached.size () == link.size () && std::all_of (link.begin (), link.end (), [] (const auto& node) {
             return node.second.size () <= 2;
           });
  }

private:
  static Edge key (int a, int b) { return {std::min (a, b), std::max (a, b)}; }

  void flood (std::size_t f, int component)
  {
    if (component_[f] >= 0)
      return;
    component_[f] = component;
    for (int i = 0; i < 3; ++i)
      for (const std::size_t g : uses_[key (triangles_[f][i], triangles_[f][(i + 1) % 3])])
        flood (g, component);
  }

  std::map<int, std::vector<int>> linkOf (int vertex) const
  {
    std::map<int, std::vector<int>> link;
    for (const Triangle& t : triangles_)
      for (int i = 0; i < 3; ++i)
        if (t[i] == vertex) {
          link[t[(i + 1) % 3]].push_back (t[(i + 2) % 3]);
          link[t[(i + 2) % 3]].push_back (t[(i + 1) % 3]);
        }
    return link;
  }

  /** \brief Tries all ways to turn the triangles. */
  bool isOrientable (int component) const
  {
    for (unsigned turned = 0; turned < 1u << triangles_.size (); ++turned) {
      const auto forward = [&] (std::size_t f, const Edge& edge) {
        const Triangle& t = triangles_[f];
        bool along = false;
        for (int i = 0; i < 3; ++i)
          along = along || (t[i] == edge[0] && t[(i + 1) % 3] == edge[1]);
        return along != ((turned >> f & 1u) != 0);
      };
      bool agree = true;
      for (const auto& [edge, faces] : uses_)
        if (faces.size () == 2 && component_[faces[0]] == component)
          agree = agree && forward (faces[0], edge) != forward (faces[1], edge);
      if (agree)
        return true;
    }
    return false;
  }

  /** \brief Walks through the links of the vertices and merges the names of boundary edges. */
  std::size_t loops (int component) const
  {
    std::map<Edge, Edge> name;
    for (const auto& [edge, faces] : uses_)
      if (faces.size () == 1 && component_[faces[0]] == component)
        name[edge] = edge;
    const auto merge = [&] (const Edge& a, const Edge& b) {
      const Edge from = name.at (a), to = name.at (b);
      for (auto& entry : name)
        if (entry.second == from)
          entry.second = to;
    };
    std::map<int, Edge> stopped;
    const std::map<Edge, Edge> edges = name;
    for (const auto& [edge, unused] : edges)
      for (int end = 0; end < 2; ++end) {
        const std::map<int, std::vector<int>> link = linkOf (edge[end]);
        int before = edge[1 - end];
        int at = link.at (before)[0];
        while (link.at (at).size () == 2) {
          const int next = link.at (at)[0] == before ? link.at (at)[1] : link.at (at)[0];
          before = at;
          at = next;
        }
        if (link.at (at).size () == 1)
          merge (edge, key (edge[end], at));
        else if (const auto [entry, first] = stopped.emplace (edge[end], edge); !first)
          merge (edge, entry->second);
      }
    std::set<Edge> names;
    for (const auto& entry : name)
      names.insert (entry.second);
    return names.size ();
  }

  std::vector<Triangle> triangles_;
  std::map<Edge, std::vector<std::size_t>> uses_;
  std::vector<int> component_;
  int components_ = 0;
};

} // namespace oracle
