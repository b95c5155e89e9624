#include "graph/faces/mesh_components.h"

#include "complex/disjoint_sets.h"

#include <algorithm>
#include <cstdint>

namespace pcl {
namespace manifold {

namespace {

using Edge = LandmarkMesh::Edge;

// One side of a face: an edge from one landmark to the next.
struct Side
{
  std::size_t edge;
  std::uint32_t face;
  bool upward; ///< from the smaller to the larger end
};

// Counts what a mesh has, component by component.
class MeshAnalysis
{
public:
  MeshAnalysis (const LandmarkMesh& mesh, std::size_t landmarks) : mesh_ (mesh), edges_ (mesh.edges)
  {
    std::sort (edges_.begin (), edges_.end ());
    edges_.erase (std::unique (edges_.begin (), edges_.end ()), edges_.end ());
    collectSides ();
    DisjointSets sets (landmarks);
    for (const Edge& edge : edges_)
      sets.join (static_cast<std::uint32_t> (edge[0]), static_cast<std::uint32_t> (edge[1]));
    components_.resize (sets.number (component_));
  }

  MeshComponents run ()
  {
    for (const std::uint32_t component : component_)
      ++components_[component].vertices;
    for (const auto& face : mesh_.faces) {
      LandmarkComponent& component = componentOf (face.front ());
      ++component.faces;
      component.triangles += face.size () == 3 ? 1 : 0;
    }
    countEdges ();
    countLoops ();
    findOneSided ();
    return {std::move (component_), std::move (components_)};
  }

private:
  LandmarkComponent& componentOf (pcl::index_t landmark) { return components_[component_[landmark]]; }

  std::size_t edgeBetween (pcl::index_t a, pcl::index_t b) const
  {
    const Edge edge{std::min (a, b), std::max (a, b)};
    return static_cast<std::size_t> (std::lower_bound (edges_.begin (), edges_.end (), edge) -
                                     edges_.begin ());
  }

  bool isEdge (std::size_t number, pcl::index_t a, pcl::index_t b) const
  {
    return number < edges_.size () && edges_[number] == Edge{std::min (a, b), std::max (a, b)};
  }

  // Sides of faces that are no edges of the mesh make edges of their own.
  void collectSides ()
  {
    std::vector<Edge> missing;
    forEachSide ([&] (std::uint32_t, pcl::index_t a, pcl::index_t b) {
      if (!isEdge (edgeBetween (a, b), a, b))
        missing.push_back ({std::min (a, b), std::max (a, b)});
    });
    if (!missing.empty ()) {
      edges_.insert (edges_.end (), missing.begin (), missing.end ());
      std::sort (edges_.begin (), edges_.end ());
      edges_.erase (std::unique (edges_.begin (), edges_.end ()), edges_.end ());
    }
    uses_.assign (edges_.size (), 0);
    forEachSide ([&] (std::uint32_t face, pcl::index_t a, pcl::index_t b) {
      sides_.push_back ({edgeBetween (a, b), face, a < b});
      ++uses_[sides_.back ().edge];
    });
  }

  template <typename Visit>
  void forEachSide (const Visit& visit) const
  {
    for (std::uint32_t f = 0; f < mesh_.faces.size (); ++f)
      for (std::size_t i = 0; i < mesh_.faces[f].size (); ++i)
        visit (f, mesh_.faces[f][i], mesh_.faces[f][i + 1 < mesh_.faces[f].size () ? i + 1 : 0]);
  }

  void countEdges ()
  {
    for (std::size_t e = 0; e < edges_.size (); ++e) {
      LandmarkComponent& component = componentOf (edges_[e][0]);
      ++component.edges;
      ++(uses_[e] == 0   ? component.edges_in_no_face
         : uses_[e] == 1 ? component.edges_in_one_face
         : uses_[e] == 2 ? component.edges_in_two_faces
                         : component.edges_in_more_faces);
    }
  }

  // A hole of the mesh is a loop. Another loop goes from an edge in one face to the next one that bounds the
  // same fan of faces around their common landmark. Both ends of an edge are known apart, and corners of
  // faces join the ends of two edges.
  void countLoops ()
  {
    DisjointSets ends (2 * edges_.size ());
    const auto endOf = [this] (std::size_t edge, pcl::index_t landmark) {
      return static_cast<std::uint32_t> (2 * edge + (edges_[edge][1] == landmark ? 1 : 0));
    };
    std::size_t first = 0;
    for (const auto& face : mesh_.faces) {
      for (std::size_t i = 0; i < face.size (); ++i)
        ends.join (endOf (sides_[first + (i > 0 ? i : face.size ()) - 1].edge, face[i]),
                   endOf (sides_[first + i].edge, face[i]));
      first += face.size ();
    }
    for (std::uint32_t e = 0; e < edges_.size (); ++e)
      if (uses_[e] == 1)
        ends.join (2 * e, 2 * e + 1);
    std::vector<std::uint8_t> counted (2 * edges_.size (), 0);
    // Nothing of the loops that the holes are is counted again.
    for (const auto& hole : mesh_.holes) {
      ++componentOf (hole.front ()).boundary_loops;
      for (std::size_t i = 0; i < hole.size (); ++i) {
        const std::size_t edge = edgeBetween (hole[i], hole[i + 1 < hole.size () ? i + 1 : 0]);
        if (isEdge (edge, hole[i], hole[i + 1 < hole.size () ? i + 1 : 0]))
          counted[ends.find (static_cast<std::uint32_t> (2 * edge))] = 1;
      }
    }
    for (std::uint32_t e = 0; e < edges_.size (); ++e)
      if (std::uint8_t& seen = counted[ends.find (2 * e)]; uses_[e] == 1 && seen == 0) {
        seen = 1;
        ++componentOf (edges_[e][0]).boundary_loops;
      }
  }

  // Every face has two directions, known apart. Neighbours across an edge of two faces join those that agree;
  // a face that is joined with its own other direction is of a one-sided part.
  void findOneSided ()
  {
    std::vector<const Side*> first (edges_.size (), nullptr);
    DisjointSets directions (2 * mesh_.faces.size ());
    for (const Side& side : sides_) {
      if (uses_[side.edge] != 2)
        continue;
      const Side*& other = first[side.edge];
      if (other != nullptr) {
        const std::uint32_t turn = other->upward == side.upward ? 1 : 0;
        directions.join (2 * other->face, 2 * side.face + turn);
        directions.join (2 * other->face + 1, 2 * side.face + 1 - turn);
      }
      other = &side;
    }
    for (std::uint32_t f = 0; f < mesh_.faces.size (); ++f)
      if (directions.find (2 * f) == directions.find (2 * f + 1))
        componentOf (mesh_.faces[f].front ()).orientable = false;
  }

  const LandmarkMesh& mesh_;
  std::vector<Edge> edges_;
  std::vector<Side> sides_;         ///< face by face
  std::vector<std::uint32_t> uses_; ///< per edge: how many sides
  std::vector<std::uint32_t> component_;
  std::vector<LandmarkComponent> components_;
};

} // namespace

MeshComponents
findComponents (const LandmarkMesh& mesh, std::size_t landmarks)
{
  return MeshAnalysis (mesh, landmarks).run ();
}

LandmarkMeshReport
analyze (const LandmarkMesh& mesh, std::size_t landmarks)
{
  LandmarkMeshReport report;
  report.components = findComponents (mesh, landmarks).components;
  LandmarkComponent& total = report.total;
  for (const LandmarkComponent& component : report.components) {
    total.vertices += component.vertices;
    total.edges += component.edges;
    total.faces += component.faces;
    total.triangles += component.triangles;
    total.edges_in_no_face += component.edges_in_no_face;
    total.edges_in_one_face += component.edges_in_one_face;
    total.edges_in_two_faces += component.edges_in_two_faces;
    total.edges_in_more_faces += component.edges_in_more_faces;
    total.boundary_loops += component.boundary_loops;
    total.orientable = total.orientable && component.orientable;
  }
  std::stable_sort (
    report.components.begin (), report.components.end (),
    [] (const LandmarkComponent& a, const LandmarkComponent& b) { return a.vertices > b.vertices; });
  return report;
}

} // namespace manifold
} // namespace pcl
