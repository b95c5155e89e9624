#include "voronoi/contradiction.h"

#include <algorithm>
#include <cmath>

namespace pcl {
namespace manifold {

namespace {

constexpr double BESIDE = 0.70710678118654752; // at 45 degrees from the tangent
constexpr std::ptrdiff_t FEW = 4;              // one in so many may be beside the curve

// The ratio of the heights across a surface, and along it, that rows may have. That of a curve is about 1
// across, and along it as small as the other curves are far.
constexpr double FLAT = 0.3;
constexpr double APART = 12.0;

bool
isInARow (const Eigen::Vector3d& heights)
{
  return std::isfinite (heights[1]) && heights[0] * APART > heights[1] && heights[1] < FLAT * heights[2];
}

} // namespace

bool
isContradicted (const SampleDimensions& dimensions, const VoronoiCell& cell,
                const std::vector<std::int32_t>& nearest)
{
  if (dimensions.complex->affine_dimension < 3)
    return false;
  const Eigen::Vector3d tangent = dimensions.tangents.col (cell.sample ());
  const auto beside = std::count_if (nearest.begin (), nearest.end (), [&] (std::int32_t q) {
    return std::abs (cell.relative (q).normalized ().dot (tangent)) < BESIDE;
  });
  return FEW * beside > static_cast<std::ptrdiff_t> (nearest.size ()) ||
         isInARow (dimensions.heights.col (cell.sample ()));
}

} // namespace manifold
} // namespace pcl
