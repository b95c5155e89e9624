#include "complex/component_vertices.h"
#include "complex/disjoint_sets.h"
#include "complex/surface_sides.h"
#include "complex/tetrahedron_sides.h"
#include "complex/topology_parts.h"
#include "complex/vertex_numbering.h"

#include <algorithm>
#include <iterator>

namespace pcl {
namespace manifold {

SolidTopology
analyzeSolid (const std::vector<SimplicialComplex::Tetrahedron>& tetrahedra)
{
  std::vector<SimplicialComplex::Tetrahedron> proper;
  proper.reserve (tetrahedra.size ());
  std::copy_if (tetrahedra.begin (), tetrahedra.end (), std::back_inserter (proper),
                [] (const auto& t) { return !isDegenerate (t); });
  const VertexNumbering numbering ({proper});
  SolidTopology total;
  total.tetrahedra = proper.size ();
  total.vertices = numbering.size ();
  total.degenerate_tetrahedra = tetrahedra.size () - proper.size ();

  DisjointSets sets (proper.size ());
  std::vector<std::uint32_t> boundary;
  TetrahedronSides (proper).forEachTriangle ([&] (auto first, auto last) {
    ++total.triangles;
    total.non_manifold_triangles += last - first > 2;
    if (last - first == 1)
      boundary.push_back (*first);
    for (auto i = first + 1; i < last; ++i)
      sets.join (*first / 4, *i / 4);
  });
  total.boundary_triangles = boundary.size ();

  std::vector<std::uint32_t> component_of;
  total.components.resize (sets.number (component_of));
  for (const std::uint32_t side : boundary)
    ++total.components[component_of[side / 4]].boundary_triangles;
  ComponentVertices members (numbering.size ());
  for (std::size_t i = 0; i < proper.size (); ++i) {
    ++total.components[component_of[i]].tetrahedra;
    for (const pcl::index_t v : proper[i])
      members.add (numbering[v], component_of[i]);
  }
  members.forEach ([&] (std::uint32_t, std::uint32_t component) { ++total.components[component].vertices; });
  std::stable_sort (
    total.components.begin (), total.components.end (),
    [] (const SolidComponent& a, const SolidComponent& b) { return a.tetrahedra > b.tetrahedra; });
  std::sort (boundary.begin (), boundary.end ());
  total.boundary = analyzeSurface (toFaceRows (sidesOf (proper, boundary)));
  return total;
}

} // namespace manifold
} // namespace pcl
