#pragma once

#include <pcl/manifold/sample_dimensions.h>

#include "voronoi/voronoi_cell.h"

#include <cstdint>
#include <vector>

namespace pcl {
namespace manifold {

/** Half the opening of a cocone, Definition 5.1 of Dey, Giesen, Goswami and Zhao: pi / 8. */
extern const double COCONE_SINE;
extern const double COCONE_COSINE;

/** Whether the cocone of a surface sample p with the given unit normal, the points of its Voronoi cell within
 * pi/8 of the plane V2, meets the Voronoi edge from vertex a to vertex b of the cell of p: then the dual
 * triangle is a candidate. */
bool coconeMeetsEdge (const VoronoiCell& cell, const Eigen::Vector3d& normal, std::int32_t a, std::int32_t b);

/** The Delaunay neighbours q of a curve sample p with the given unit tangent for which the cocone of p, the
 * points of its Voronoi cell within pi/8 of the line V1, meets the Voronoi face dual to the edge from p to q;
 * ascending. */
std::vector<std::int32_t> coconeNeighbors (const DelaunayComplex& complex, const VoronoiCell& cell,
                                           const Eigen::Vector3d& tangent);

} // namespace manifold
} // namespace pcl
