#include <pcl/manifold/graph_faces.h>

#include "graph/faces/face_cutter.h"

namespace pcl {
namespace manifold {

std::vector<FaceCutter::Triangle>
triangulateFaces (const LandmarkMesh& mesh, const Eigen::Ref<const Eigen::MatrixXd>& points)
{
  FaceCutter cutter (mesh, points);
  std::vector<FaceCutter::Triangle> triangles;
  for (const FaceCutter::Walk& face : mesh.faces)
    if (face.size () == 3)
      triangles.push_back ({face[0], face[1], face[2]});
    else if (face.size () > 3)
      cutter.cut (face, triangles);
  return triangles;
}

} // namespace manifold
} // namespace pcl
