#pragma once

#include "fixed_point/number_vector.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>

namespace pcl {
namespace manifold {

/** Coordinates on a grid that are by less than 2^8 apart: no expression here can overflow, those of degree
 * six being less than 2^13 times the sixth power of that. */
using LatticeNumber = std::int64_t;
constexpr double LATTICE_SIZE = 128.0;

template <>
inline LatticeNumber
differenceOf<LatticeNumber> (double x, double y)
{
  return static_cast<LatticeNumber> (x) - static_cast<LatticeNumber> (y);
}

inline int
signOf (LatticeNumber x)
{
  return x > 0 ? 1 : (x < 0 ? -1 : 0);
}

/** Where points are near each other on a grid, shifts and scales them to small integers. Points on grids are
 * cospherical everywhere, so that rounding leaves hardly anything certain, and what follows without it is
 * much faster in small integers.
 * \return whether that was possible; if not, the points are of no use any more */
bool moveToLattice (Eigen::Vector3d* points, std::size_t count);

template <std::size_t Count>
bool
moveToLattice (std::array<Eigen::Vector3d, Count>& points)
{
  return moveToLattice (points.data (), Count);
}

} // namespace manifold
} // namespace pcl
