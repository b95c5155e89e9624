#include "graph/faces/mesh_components.h"

#include "complex/disjoint_sets.h"
#include "complex/surface_patches.h"

namespace pcl {
namespace manifold {

MeshComponents
findComponents (const LandmarkMesh& mesh, std::size_t landmarks)
{
  DisjointSets sets (landmarks);
  for (const LandmarkMesh::Edge& edge : mesh.edges)
    sets.join (static_cast<std::uint32_t> (edge[0]), static_cast<std::uint32_t> (edge[1]));
  MeshComponents result;
  result.components.resize (sets.number (result.component_of));
  const auto componentOf = [&result] (pcl::index_t landmark) -> MeshComponent& {
    return result.components[result.component_of[landmark]];
  };
  for (const std::uint32_t component : result.component_of)
    ++result.components[component].vertices;
  for (const LandmarkMesh::Edge& edge : mesh.edges)
    ++componentOf (edge[0]).edges;
  for (const auto& face : mesh.faces)
    ++componentOf (face.front ()).faces;
  for (const auto& hole : mesh.holes)
    ++componentOf (hole.front ()).holes;
  const SurfaceSides sides (toFaceRows (mesh));
  const SurfacePatches patches (sides);
  for (std::size_t f = 0; f < sides.faces (); ++f)
    if (patches.orientable[patches.patch[f]] == 0)
      componentOf (mesh.faces[sides.source[f]].front ()).orientable = false;
  return result;
}

FaceRows
toFaceRows (const LandmarkMesh& mesh)
{
  FaceRows rows;
  for (const auto& face : mesh.faces) {
    rows.vertices.insert (rows.vertices.end (), face.begin (), face.end ());
    rows.starts.push_back (rows.vertices.size ());
  }
  return rows;
}

pcl::TopologyReport
analyze (const LandmarkMesh& mesh)
{
  return analyze (toFaceRows (mesh), mesh.edges);
}

} // namespace manifold
} // namespace pcl
