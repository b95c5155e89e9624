#pragma once

#include <pcl/manifold/graph_faces.h>

namespace pcl {
namespace manifold {

/** Turns the faces of every part of a mesh that hangs together through edges such that it encloses a positive
 * volume: outwards, where it is closed. Faces that agree go on agreeing.
 * \param[in] points coordinates of the landmarks, finite */
void turnOutward (LandmarkMesh& mesh, const Eigen::Matrix3Xd& points);

} // namespace manifold
} // namespace pcl
