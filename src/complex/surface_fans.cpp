#include "complex/surface_fans.h"

namespace pcl {
namespace manifold {

namespace {

/** \brief Walks around the vertex of a corner, leaving the corner's face across one of the corner's two
 * sides. A corner goes by the number of the side that leaves it.
 * \return the side at which the walk ended, or SurfaceSides::border if it came back to where it started */
std::uint32_t
walkAround (const SurfaceSides& sides, std::uint32_t start, std::uint32_t side, std::vector<bool>& seen)
{
  const std::uint32_t vertex = sides.origin[start];
  while (sides.hasTwin (side)) {
    const std::uint32_t twin = sides.twin[side];
    // Neighbours may disagree in direction: the twin either leaves the vertex or arrives at it.
    const bool leaves = sides.origin[twin] == vertex;
    const std::uint32_t corner = leaves ? twin : sides.next (twin);
    if (corner == start)
      return SurfaceSides::border;
    seen[corner] = true;
    side = leaves ? sides.previous (corner) : corner;
  }
  return side;
}

} // namespace

std::vector<SurfaceFan>
findFans (const SurfaceSides& sides)
{
  std::vector<SurfaceFan> fans;
  fans.reserve (sides.vertices);
  std::vector<bool> seen (sides.origin.size (), false);
  for (std::uint32_t corner = 0; corner < sides.origin.size (); ++corner) {
    if (seen[corner])
      continue;
    seen[corner] = true;
    SurfaceFan fan{sides.origin[corner], sides.face[corner], false, {}};
    fan.ends[0] = walkAround (sides, corner, corner, seen);
    fan.closed = fan.ends[0] == SurfaceSides::border;
    if (!fan.closed)
      fan.ends[1] = walkAround (sides, corner, sides.previous (corner), seen);
    fans.push_back (fan);
  }
  return fans;
}

} // namespace manifold
} // namespace pcl
