#pragma once

#include "complex/surface_sides.h"

#include <cstddef>

namespace pcl {
namespace manifold {

/** \brief How many faces go through the same vertices in the same order, either way around, as one before. */
std::size_t countDuplicateFaces (const SurfaceSides& sides);

} // namespace manifold
} // namespace pcl
