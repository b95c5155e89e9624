#include "complex/component_vertices.h"
#include "complex/disjoint_sets.h"
#include "complex/duplicate_faces.h"
#include "complex/surface_fans.h"
#include "complex/surface_patches.h"
#include "complex/surface_sides.h"
#include "complex/topology_parts.h"

#include <algorithm>
#include <tuple>

namespace pcl {
namespace manifold {

namespace {

/** \brief Gathers the report of one surface, a kind of count after the other. */
class SurfaceAnalysis
{
public:
  explicit SurfaceAnalysis (const FaceRows& faces) : sides_ (faces), fans_ (findFans (sides_)) {}

  SurfaceTopology run ()
  {
    findComponents ();
    countFaces ();
    countEdges ();
    countVertices ();
    countLoops ();
    classify ();
    std::stable_sort (
      total_.components.begin (), total_.components.end (),
      [] (const SurfaceComponent& a, const SurfaceComponent& b) { return a.faces > b.faces; });
    return std::move (total_);
  }

private:
  void findComponents ()
  {
    DisjointSets sets (sides_.faces ());
    for (std::size_t e = 0; e < sides_.edges (); ++e)
      for (std::uint32_t i = sides_.edge_starts[e] + 1; i < sides_.edge_starts[e + 1]; ++i)
        sets.join (sides_.face[sides_.edge_sides[i - 1]], sides_.face[sides_.edge_sides[i]]);
    total_.components.resize (sets.number (component_));
  }

  SurfaceComponent& componentOfFace (std::uint32_t face) { return total_.components[component_[face]]; }

  void countFaces ()
  {
    for (std::uint32_t f = 0; f < sides_.faces (); ++f) {
      ++componentOfFace (f).faces;
      total_.triangles += sides_.starts[f + 1] - sides_.starts[f] == 3;
    }
    total_.faces = sides_.faces ();
    total_.degenerate_faces = sides_.degenerate_faces;
    total_.duplicate_faces = countDuplicateFaces (sides_);
  }

  void countEdges ()
  {
    for (std::size_t e = 0; e < sides_.edges (); ++e) {
      const std::uint32_t first = sides_.edge_starts[e];
      const std::uint32_t uses = sides_.edge_starts[e + 1] - first;
      SurfaceComponent& component = componentOfFace (sides_.face[sides_.edge_sides[first]]);
      ++component.edges;
      ++(uses == 1   ? component.boundary_edges
         : uses == 2 ? component.inner_edges
                     : component.non_manifold_edges);
    }
    total_.edges = sides_.edges ();
    for (const SurfaceComponent& component : total_.components) {
      total_.boundary_edges += component.boundary_edges;
      total_.inner_edges += component.inner_edges;
      total_.non_manifold_edges += component.non_manifold_edges;
    }
  }

  void countVertices ()
  {
    std::vector<std::uint8_t> manifold (sides_.vertices, 1);
    std::vector<std::uint8_t> met (sides_.vertices, 0);
    ComponentVertices members (sides_.vertices);
    for (const SurfaceFan& fan : fans_) {
      if (met[fan.vertex] != 0 || endsInNonManifoldEdge (fan))
        manifold[fan.vertex] = 0;
      met[fan.vertex] = 1;
      members.add (fan.vertex, component_[fan.face]);
    }
    members.forEach ([&] (std::uint32_t vertex, std::uint32_t component) {
      ++total_.components[component].vertices;
      total_.components[component].non_manifold_vertices += manifold[vertex] == 0;
    });
    total_.vertices = sides_.vertices;
    total_.non_manifold_vertices =
      static_cast<std::size_t> (std::count (manifold.begin (), manifold.end (), 0));
  }

  /** \brief Boundary edges are joined where a walk along the boundary goes from one to the other. */
  void countLoops ()
  {
    DisjointSets loops (sides_.origin.size ());
    // Boundary edges whose fan ends in a non-manifold edge, by vertex and component.
    std::vector<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>> stopped;
    for (const SurfaceFan& fan : fans_) {
      if (fan.closed)
        continue;
      if (!endsInNonManifoldEdge (fan))
        loops.join (fan.ends[0], fan.ends[1]);
      else
        for (const std::uint32_t side : fan.ends)
          if (sides_.twin[side] == SurfaceSides::border)
            stopped.emplace_back (fan.vertex, component_[fan.face], side);
    }
    std::sort (stopped.begin (), stopped.end ());
    for (std::size_t i = 1; i < stopped.size (); ++i) {
      const auto& [vertex, component, side] = stopped[i];
      const auto& [vertex_before, component_before, side_before] = stopped[i - 1];
      if (vertex == vertex_before && component == component_before)
        loops.join (side, side_before);
    }
    for (std::uint32_t s = 0; s < sides_.twin.size (); ++s)
      if (sides_.twin[s] == SurfaceSides::border && loops.find (s) == s)
        ++componentOfFace (sides_.face[s]).boundary_loops;
    for (const SurfaceComponent& component : total_.components)
      total_.boundary_loops += component.boundary_loops;
  }

  /** \brief Orientability, Euler characteristic and genus. */
  void classify ()
  {
    const SurfacePatches patches (sides_);
    for (SurfaceComponent& component : total_.components)
      component.orientable = true;
    for (std::uint32_t f = 0; f < sides_.faces (); ++f)
      if (patches.orientable[patches.patch[f]] == 0)
        componentOfFace (f).orientable = false;

    std::vector<std::size_t> fans (total_.components.size (), 0);
    for (const SurfaceFan& fan : fans_)
      ++fans[component_[fan.face]];
    for (std::size_t i = 0; i < total_.components.size (); ++i) {
      SurfaceComponent& component = total_.components[i];
      component.closed = component.boundary_edges == 0;
      component.euler_characteristic = euler (component.vertices, component.edges, component.faces);
      if (component.non_manifold_edges > 0)
        continue;
      const std::int64_t missing = 2 - euler (fans[i], component.edges, component.faces) -
                                   static_cast<std::int64_t> (component.boundary_loops);
      component.genus = static_cast<int> (component.orientable ? missing / 2 : missing);
    }
    total_.euler_characteristic = euler (total_.vertices, total_.edges, total_.faces);
  }

  static std::int64_t euler (std::size_t vertices, std::size_t edges, std::size_t faces)
  {
    return static_cast<std::int64_t> (vertices + faces) - static_cast<std::int64_t> (edges);
  }

  bool endsInNonManifoldEdge (const SurfaceFan& fan) const
  {
    return !fan.closed && (sides_.twin[fan.ends[0]] == SurfaceSides::non_manifold ||
                           sides_.twin[fan.ends[1]] == SurfaceSides::non_manifold);
  }

  const SurfaceSides sides_;
  const std::vector<SurfaceFan> fans_;
  std::vector<std::uint32_t> component_; ///< of each face
  SurfaceTopology total_;
};

} // namespace

SurfaceTopology
analyzeSurface (const FaceRows& faces)
{
  return SurfaceAnalysis (faces).run ();
}

} // namespace manifold
} // namespace pcl
