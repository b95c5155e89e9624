#pragma once

#include <pcl/manifold/graph_faces.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace manifold {

/** What hangs together through edges of a mesh of landmarks, be they in faces or not. */
struct MeshComponent
{
  std::size_t vertices = 0;
  std::size_t edges = 0;
  std::size_t faces = 0;
  std::size_t holes = 0;
  bool orientable = true;
};

/** The components of a mesh of landmarks, numbered by their first landmarks. */
struct MeshComponents
{
  std::vector<std::uint32_t> component_of; ///< per landmark
  std::vector<MeshComponent> components;

  const MeshComponent& of (pcl::index_t landmark) const { return components[component_of[landmark]]; }
};

/** \param[in] mesh all sides of its faces are among its edges
 * \param[in] landmarks the number of landmarks: all numbers in the mesh are below it */
MeshComponents findComponents (const LandmarkMesh& mesh, std::size_t landmarks);

/** The faces of a mesh as rows. */
FaceRows toFaceRows (const LandmarkMesh& mesh);

} // namespace manifold
} // namespace pcl
