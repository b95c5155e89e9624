#pragma once

#include <pcl/manifold/sample_dimensions.h>

#include <cstdint>
#include <vector>

namespace pcl {
namespace manifold {

/** What a sample is to the extraction. */
enum class Role : std::uint8_t
{
  CURVE,   ///< on a curve
  SURFACE, ///< inside of a surface or on the skin of a solid, its boundary surface: its normal is known
  RIM,     ///< on the boundary of a surface, or an edge of a solid: it has no normal of its own
  SOLID    ///< inside of a solid
};

/** The role of every sample, from its published label and its manifold dimension. */
std::vector<Role> sampleRoles (const SampleDimensions& dimensions);

} // namespace manifold
} // namespace pcl
