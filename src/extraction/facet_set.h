#pragma once

#include "extraction/fan.h"
#include "voronoi/voronoi_cell.h"

#include <array>
#include <cstdint>
#include <vector>

namespace pcl {
namespace manifold {

/** A Delaunay triangle as a facet of one of its two cells. */
struct Facet
{
  std::int32_t cell;
  int facet;

  bool operator== (const Facet& other) const { return cell == other.cell && facet == other.facet; }

  bool operator<(const Facet& other) const
  {
    return cell != other.cell ? cell < other.cell : facet < other.facet;
  }
};

/** A set of Delaunay triangles, each given as a facet of either of its two cells. */
class FacetSet
{
public:
  explicit FacetSet (const DelaunayComplex& complex) : complex_ (&complex), mask_ (complex.cells.size (), 0)
  {}

  const DelaunayComplex& complex () const { return *complex_; }

  bool contains (std::int32_t cell, int facet) const { return (mask_[cell] >> facet & 1) != 0; }

  void insert (std::int32_t cell, int facet);

  void erase (std::int32_t cell, int facet);

  /** Calls visit (cell, facet) once for every triangle of the set at a sample. */
  template <typename Visit>
  void forEachAt (std::int32_t sample, const Visit& visit) const
  {
    VoronoiCell (*complex_, sample).forEachEdge ([&] (std::int32_t a, std::int32_t, int facet) {
      if (contains (a, facet))
        visit (a, facet);
    });
  }

  /** The link of a sample in the set. */
  void fanAt (std::int32_t sample, Fan& fan) const;

  /** What every sample has of the set, all at once: bit COVERED if there is a triangle, bit OPEN if these do
   * not form disks. Right where the set is manifold. */
  std::vector<std::uint8_t> coverage () const;
  static constexpr std::uint8_t COVERED = 1;
  static constexpr std::uint8_t OPEN = 2;

  /** The triangles, each from its cell for which `first` is true or, if for neither or both, from the one
   * with the smaller number; seen from outside of that cell their samples are in counterclockwise order. */
  template <typename First>
  std::vector<std::array<std::int32_t, 3>> triangles (const First& first) const;

private:
  void toggle (std::int32_t cell, int facet);

  const DelaunayComplex* complex_;
  std::vector<std::uint8_t> mask_; // one bit a facet, set in both cells
};

/** The samples of a facet of a cell, or INFINITE_VERTEX among them, in the order in which they are seen
 * counterclockwise from outside of the cell. */
std::array<std::int32_t, 3> facetOf (const DelaunayComplex& complex, std::int32_t cell, int facet);

/** The two samples other than the given one of a facet at that sample, in the order in which they are seen
 * counterclockwise around that sample from outside of the cell. */
std::array<std::int32_t, 2> oppositeSide (const DelaunayComplex& complex, std::int32_t cell, int facet,
                                          std::int32_t sample);

/** The number that the neighbour across a facet has for that facet. */
int mirrorFacet (const DelaunayComplex& complex, std::int32_t cell, int facet);

template <typename First>
std::vector<std::array<std::int32_t, 3>>
FacetSet::triangles (const First& first) const
{
  std::vector<std::array<std::int32_t, 3>> result;
  for (std::size_t i = 0; i < mask_.size (); ++i) {
    if (mask_[i] == 0)
      continue;
    const auto cell = static_cast<std::int32_t> (i);
    for (int facet = 0; facet < 4; ++facet) {
      const std::int32_t neighbor = complex_->neighbors[i][facet];
      if (!contains (cell, facet) || cell > neighbor)
        continue;
      if (first (neighbor) && !first (cell))
        result.push_back (facetOf (*complex_, neighbor, mirrorFacet (*complex_, cell, facet)));
      else
        result.push_back (facetOf (*complex_, cell, facet));
    }
  }
  return result;
}

} // namespace manifold
} // namespace pcl
