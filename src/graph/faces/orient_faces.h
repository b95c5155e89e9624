#pragma once

#include <pcl/manifold/graph_faces.h>

namespace pcl {
namespace manifold {

/** Lets every face and hole begin at its smallest landmark and go on to the smaller of its neighbours, puts
 * them in ascending order, and then turns those that do not agree with the first one of their part of the
 * mesh, where that is orientable. A hole is turned as a face in its place would be. */
void orientFaces (LandmarkMesh& mesh);

} // namespace manifold
} // namespace pcl
