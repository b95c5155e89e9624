#pragma once

#include "scales/point_paths.h"

#include <cstdint>
#include <vector>

namespace pcl {
namespace manifold {

/** Makes points ones of a curve that belong to a piece of one on some levels, if at least half of the points
 * of that piece are ones of a curve there by themselves: a curve goes on through gaps and beside other
 * things. */
void adoptByPieces (const PointPaths& paths, std::vector<Choice>& choices);

/** Numbers the curves by their first points. Pieces that share points of curves, on the same level or on
 * different ones, are one curve.
 * \param[out] curve per point, -1 where it is of none
 * \return how many there are */
std::int32_t joinCurves (const PointPaths& paths, const std::vector<Choice>& choices,
                         std::vector<std::int32_t>& curve);

} // namespace manifold
} // namespace pcl
