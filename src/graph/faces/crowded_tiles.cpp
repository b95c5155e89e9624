#include "graph/faces/crowded_tiles.h"

#include "graph/faces/face_cutter.h"

#include <algorithm>

namespace pcl {
namespace manifold {

std::vector<pcl::index_t>
crowdedTiles (const LandmarkMesh& mesh)
{
  const Eigen::MatrixXd no_points;
  FaceCutter cutter (mesh, no_points);
  std::vector<pcl::index_t> crowded;
  std::vector<pcl::index_t> sorted;
  for (const auto& face : mesh.faces) {
    if (face.size () <= 3)
      continue;
    sorted = face;
    std::sort (sorted.begin (), sorted.end ());
    if (std::adjacent_find (sorted.begin (), sorted.end ()) != sorted.end () || !cutter.canCut (face))
      crowded.insert (crowded.end (), sorted.begin (), sorted.end ());
  }
  std::sort (crowded.begin (), crowded.end ());
  crowded.erase (std::unique (crowded.begin (), crowded.end ()), crowded.end ());
  return crowded;
}

} // namespace manifold
} // namespace pcl
