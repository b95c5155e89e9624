#pragma once

#include "common/parallel.h"
#include "fixed_point/facet_flags.h"
#include "fixed_point/piece_walk.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace manifold {

/** The Delaunay triangles that each of many pieces generates: those of piece i are facets[offsets[i]] to
 * facets[offsets[i + 1]]. */
struct Children
{
  std::vector<std::size_t> offsets{0};
  std::vector<Facet> facets;

  void append (const Children& other);
};

/** The children of n pieces, in parallel in the current arena.
 * \param[in] find find (walk, i) gives those of piece i by a PieceWalk */
template <typename Find>
Children
generateChildren (const DelaunayComplex& complex, std::size_t n, const Find& find)
{
  // Pieces of a fixed size, so that the order of the result does not depend on the threads.
  constexpr std::size_t PART = 256;
  std::vector<Children> parts ((n + PART - 1) / PART);
  parallelRanges (
    parts.size (),
    [&] (std::size_t begin, std::size_t end) {
      PieceWalk walk (complex);
      for (std::size_t part = begin; part < end; ++part)
        for (std::size_t i = part * PART; i < std::min (n, (part + 1) * PART); ++i) {
          const std::vector<Facet>& found = find (walk, i);
          parts[part].facets.insert (parts[part].facets.end (), found.begin (), found.end ());
          parts[part].offsets.push_back (parts[part].facets.size ());
        }
    },
    1);
  Children children;
  for (const Children& part : parts)
    children.append (part);
  return children;
}

/** The part of the restriction DAG of Khoury and Shewchuk that descends from some Delaunay triangles. */
struct RestrictionDag
{
  FacetFlags reached;       ///< the triangles themselves and all their descendants
  std::vector<Facet> nodes; ///< these by the number of steps to them, in ascending order within each
  Children children;        ///< of each node
};

/** Generates the children of every triangle once. Parallel in the current arena; the result does not depend
 * on the threads.
 * \param[in] start ascending */
RestrictionDag restrictionDag (const DelaunayComplex& complex, const std::vector<Facet>& start);

} // namespace manifold
} // namespace pcl
