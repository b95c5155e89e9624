#pragma once

#include "voronoi/voronoi_cell.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace pcl {
namespace manifold {

/** The vertex of a Voronoi subpolytope farthest from its sample. */
struct Pole
{
  Eigen::Vector3d direction; ///< unit vector
  double height;             ///< distance from the sample; infinite where the subpolytope is unbounded
};

/** The pole of the whole Voronoi cell V3; of an unbounded one the average direction of its unbounded edges.
 * Linear in the number of cells at the sample. */
Pole computePole (const VoronoiCell& cell);

/** The Voronoi subpolytopes V3, V2, V1 of one sample (Definition 2.2 of Dey, Giesen, Goswami and Zhao), each
 * as the direction of its pole and its height. */
struct Subpolytopes
{
  Eigen::Vector3d normal;   ///< unit vector to the pole of V3
  Eigen::Vector3d binormal; ///< unit vector to the pole of V2, orthogonal to the normal
  Eigen::Vector3d tangent;  ///< unit vector along V1, orthogonal to both
  Eigen::Vector3d heights;  ///< H1, H2, H3; infinite where unbounded
};

/** \param[in] complex of affine dimension 2 or 3
 * Linear in the number of cells at the sample. */
Subpolytopes computeSubpolytopes (const DelaunayComplex& complex, const VoronoiCell& cell);

} // namespace manifold
} // namespace pcl
