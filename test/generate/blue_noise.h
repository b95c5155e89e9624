#pragma once

#include <generate/point_grid.h>
#include <generate/random.h>
#include <generate/shape.h>

#include <vector>

namespace generate {

/** \brief Adds points of a shape until it is covered: each new point keeps its distance to all points of the
 * grid, and in the end no place of the shape is further than 1.001 times that from a point.
 * \param[in,out] grid the points so far, also of other shapes; the new ones are inserted
 * \param[in] tick called now and then; may be empty
 * \return the new points, in the order in which they were found */
std::vector<Eigen::Vector3d> coverShape (const Shape& shape, double spacing, PointGrid& grid, Random& random,
                                         const Tick& tick = {});

} // namespace generate
