#pragma once

#include <Eigen/Geometry>

#include <array>
#include <functional>
#include <vector>

namespace generate {

using MarchedTriangle = std::array<Eigen::Vector3d, 3>;

/** \brief Triangles of the surface where a function changes its sign, by marching tetrahedra: each cube of a
 * grid is cut into six, and each of these has at most a triangle or a quadrangle of the surface. Corners that
 * triangles share come out with the same bits. The triangles are not oriented.
 * \param[in] cells number of cubes along the longest side of \a bounds, positive */
std::vector<MarchedTriangle> marchTetrahedra (const std::function<double (const Eigen::Vector3d&)>& value,
                                              const Eigen::AlignedBox3d& bounds, int cells);

} // namespace generate
