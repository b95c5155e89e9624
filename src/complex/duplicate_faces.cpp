#include "complex/duplicate_faces.h"

#include <algorithm>
#include <set>
#include <utility>
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

/** \brief The ends of a face's edges, the smaller one first, in ascending order. */
std::vector<std::pair<std::uint32_t, std::uint32_t>>
edgesOf (const SurfaceSides& sides, std::uint32_t face)
{
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (std::uint32_t s = sides.starts[face]; s < sides.starts[face + 1]; ++s)
    edges.push_back (std::minmax ({sides.origin[s], sides.origin[sides.next (s)]}));
  std::sort (edges.begin (), edges.end ());
  return edges;
}

} // namespace

std::size_t
countDuplicateFaces (const SurfaceSides& sides)
{
  std::size_t duplicates = 0;
  std::set<std::vector<std::pair<std::uint32_t, std::uint32_t>>> known;
  for (std::uint32_t f = 0; f < sides.faces (); ++f)
    if (mayBeDuplicate (sides, f))
      duplicates += !known.insert (edgesOf (sides, f)).second;
  return duplicates;
}

} // namespace manifold
} // namespace pcl
