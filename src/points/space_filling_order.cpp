#include "points/space_filling_order.h"

#include "common/large_pages.h"
#include "common/parallel.h"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>

namespace pcl {
namespace manifold {

namespace {

constexpr int BITS_PER_AXIS = 21;

// Spreads the lowest 21 bits of x to every third bit.
std::uint64_t
spread (std::uint64_t x)
{
  x &= 0x1fffff;
  x = (x | x << 32) & 0x1f00000000ffffULL;
  x = (x | x << 16) & 0x1f0000ff0000ffULL;
  x = (x | x << 8) & 0x100f00f00f00f00fULL;
  x = (x | x << 4) & 0x10c30c30c30c30c3ULL;
  x = (x | x << 2) & 0x1249249249249249ULL;
  return x;
}

struct Key
{
  std::uint64_t code;
  std::int32_t index;
};

} // namespace

std::vector<std::int32_t>
spaceFillingOrder (const Eigen::Matrix3Xd& points, const Eigen::AlignedBox3d& box)
{
  const auto n = static_cast<std::size_t> (points.cols ());
  if (n == 0)
    return {};
  const double extent = box.sizes ().maxCoeff ();
  const double cells = extent > 0.0 ? (std::ldexp (1.0, BITS_PER_AXIS) - 1.0) / extent : 0.0;

  std::vector<Key> keys;
  assignLarge (keys, n);
  parallelFor (n, [&] (std::size_t i) {
    const Eigen::Vector3d inside = points.col (i).cwiseMax (box.min ()).cwiseMin (box.max ());
    const Eigen::Vector3d cell = (inside - box.min ()) * cells;
    keys[i].code = spread (static_cast<std::uint64_t> (cell.x ())) |
                   spread (static_cast<std::uint64_t> (cell.y ())) << 1 |
                   spread (static_cast<std::uint64_t> (cell.z ())) << 2;
    keys[i].index = static_cast<std::int32_t> (i);
  });
  tbb::parallel_sort (keys.begin (), keys.end (), [&points] (const Key& a, const Key& b) {
    if (a.code != b.code)
      return a.code < b.code;
    for (int axis = 0; axis < 3; ++axis)
      if (points (axis, a.index) != points (axis, b.index))
        return points (axis, a.index) < points (axis, b.index);
    return a.index < b.index;
  });

  std::vector<std::int32_t> order;
  assignLarge (order, n);
  parallelFor (n, [&] (std::size_t i) { order[i] = keys[i].index; });
  return order;
}

} // namespace manifold
} // namespace pcl
