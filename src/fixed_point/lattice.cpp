#include "fixed_point/lattice.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace pcl {
namespace manifold {

namespace {

// x - y, and whether it is exact.
bool
subtractExactly (double x, double y, double& difference)
{
  difference = x - y;
  const double back = difference - x;
  return x - (difference - back) == y + back; // both rounding errors, themselves exact
}

// The largest power of two that a finite number other than 0 is a multiple of.
double
lastBit (double x)
{
  constexpr std::uint64_t DIGITS = (std::uint64_t (1) << 52) - 1;
  const double size = std::abs (x);
  std::uint64_t bits = 0;
  std::memcpy (&bits, &size, sizeof (bits));
  if ((bits & DIGITS) == 0)
    return size;
  bits &= bits - 1; // without the last of its digits
  double rest = 0.0;
  std::memcpy (&rest, &bits, sizeof (rest));
  return size - rest;
}

} // namespace

bool
moveToLattice (Eigen::Vector3d* points, std::size_t count)
{
  const Eigen::Vector3d base = points[0];
  double unit = std::numeric_limits<double>::infinity ();
  double largest = 0.0;
  for (std::size_t i = 0; i < count; ++i)
    for (int axis = 0; axis < 3; ++axis) {
      double& x = points[i][axis];
      if (!subtractExactly (x, base[axis], x))
        return false;
      if (x == 0.0)
        continue;
      largest = std::max (largest, std::abs (x));
      unit = std::min (unit, lastBit (x));
      if (!(largest < LATTICE_SIZE * unit))
        return false;
    }
  for (std::size_t i = 0; i < count; ++i)
    points[i] /= unit;
  return true;
}

} // namespace manifold
} // namespace pcl
