#include "complex/duplicate_faces.h"

#include <algorithm>
#include <set>
#include <vector>

namespace pcl {
namespace manifold {

namespace {

/** \brief Can a face have a duplicate? One that has shares every edge, and where it shares each with one
 * other face only, that is the same face all around. Of a clean surface no face passes. */
bool
mayBeDuplicate (const SurfaceSides& sides, std::uint32_t face)
{
  const std::uint32_t begin = sides.starts[face], end = sides.starts[face + 1];
  const auto first = sides.twin.begin () + begin, last = sides.twin.begin () + end;
  if (std::find (first, last, SurfaceSides::border) != last)
    return false;
  if (std::find (first, last, SurfaceSides::non_manifold) != last)
    return true;
  return std::all_of (first, last,
                      [&] (std::uint32_t twin) { return sides.face[twin] == sides.face[sides.twin[begin]]; });
}

/** \brief A face's vertices from the smallest on, in the direction of that one's smaller neighbour. */
std::vector<std::uint32_t>
canonicalCycle (const SurfaceSides& sides, std::uint32_t face)
{
  std::vector<std::uint32_t> cycle (sides.origin.begin () + sides.starts[face],
                                    sides.origin.begin () + sides.starts[face + 1]);
  std::rotate (cycle.begin (), std::min_element (cycle.begin (), cycle.end ()), cycle.end ());
  if (cycle.back () < cycle[1])
    std::reverse (cycle.begin () + 1, cycle.end ());
  return cycle;
}

} // namespace

std::size_t
countDuplicateFaces (const SurfaceSides& sides)
{
  std::size_t duplicates = 0;
  std::set<std::vector<std::uint32_t>> cycles;
  for (std::uint32_t f = 0; f < sides.faces (); ++f)
    if (mayBeDuplicate (sides, f))
      duplicates += !cycles.insert (canonicalCycle (sides, f)).second;
  return duplicates;
}

} // namespace manifold
} // namespace pcl
