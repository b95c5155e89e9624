#pragma once

#include "oracle_random.h"

#include <Eigen/Core>

#include <cmath>

/** \file
 * Points for predicates: anywhere, and so near to ties that only numbers without rounding tell. */

namespace oracle {

/** \brief In the cube between -1 and 1. */
inline Eigen::Vector3d
anyPoint (Random& random)
{
  return {random.uniform (-1, 1), random.uniform (-1, 1), random.uniform (-1, 1)};
}

/** \brief A point moved by a few of the smallest steps that doubles have there, or not at all. */
inline Eigen::Vector3d
nudged (Eigen::Vector3d point, Random& random)
{
  for (int axis = 0; axis < 3; ++axis)
    for (int steps = random.index (3); steps > 0; --steps)
      point[axis] = std::nextafter (point[axis], random.coin () ? 10.0 : -10.0);
  return point;
}

} // namespace oracle
