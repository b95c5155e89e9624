#pragma once

#include <pcl/manifold/graph_faces.h>

#include <cstdint>
#include <vector>

namespace pcl {
namespace manifold {

/** The components of a mesh of landmarks, numbered by their first landmarks. */
struct MeshComponents
{
  std::vector<std::uint32_t> component_of; ///< per landmark
  std::vector<LandmarkComponent> components;
};

MeshComponents findComponents (const LandmarkMesh& mesh, std::size_t landmarks);

} // namespace manifold
} // namespace pcl
