#include "extraction/facet_set.h"

#include <algorithm>

namespace pcl {
namespace manifold {

void
FacetSet::insert (std::int32_t cell, int facet)
{
  if (!contains (cell, facet))
    toggle (cell, facet);
}

void
FacetSet::erase (std::int32_t cell, int facet)
{
  if (contains (cell, facet))
    toggle (cell, facet);
}

void
FacetSet::toggle (std::int32_t cell, int facet)
{
  mask_[cell] ^= static_cast<std::uint8_t> (1 << facet);
  mask_[complex_->neighbors[cell][facet]] ^=
    static_cast<std::uint8_t> (1 << mirrorFacet (*complex_, cell, facet));
}

void
FacetSet::fanAt (std::int32_t sample, Fan& fan) const
{
  fan.clear ();
  forEachAt (sample, [&] (std::int32_t cell, int facet) {
    const std::array<std::int32_t, 2> side = oppositeSide (*complex_, cell, facet, sample);
    fan.add (side[0], side[1]);
  });
}

std::vector<std::uint8_t>
FacetSet::coverage () const
{
  // In a disk every sample of the link belongs to two triangles, so that all the samples of the triangles
  // cancel each other; the two ends of a fan do not. One thread does this faster than several with atomic
  // counters.
  std::vector<std::uint8_t> coverage (static_cast<std::size_t> (complex_->samples->size ()), 0);
  std::vector<std::int32_t> ends (coverage.size (), 0);
  for (std::size_t i = 0; i < mask_.size (); ++i)
    for (int facet = 0; mask_[i] != 0 && facet < 4; ++facet) {
      const auto cell = static_cast<std::int32_t> (i);
      if (!contains (cell, facet) || cell > complex_->neighbors[i][facet])
        continue;
      const std::array<std::int32_t, 3> triangle = facetOf (*complex_, cell, facet);
      for (int k = 0; k < 3; ++k) {
        coverage[triangle[k]] = COVERED;
        ends[triangle[k]] ^= triangle[(k + 1) % 3] ^ triangle[(k + 2) % 3];
      }
    }
  for (std::size_t i = 0; i < ends.size (); ++i)
    if (ends[i] != 0)
      coverage[i] |= OPEN;
  return coverage;
}

std::array<std::int32_t, 3>
facetOf (const DelaunayComplex& complex, std::int32_t cell, int facet)
{
  static constexpr int OUTWARD[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
  const DelaunayComplex::Cell& vertices = complex.cells[cell];
  return {vertices[OUTWARD[facet][0]], vertices[OUTWARD[facet][1]], vertices[OUTWARD[facet][2]]};
}

std::array<std::int32_t, 2>
oppositeSide (const DelaunayComplex& complex, std::int32_t cell, int facet, std::int32_t sample)
{
  const std::array<std::int32_t, 3> triangle = facetOf (complex, cell, facet);
  const int k = triangle[0] == sample ? 0 : (triangle[1] == sample ? 1 : 2);
  return {triangle[(k + 1) % 3], triangle[(k + 2) % 3]};
}

int
mirrorFacet (const DelaunayComplex& complex, std::int32_t cell, int facet)
{
  const std::int32_t neighbor = complex.neighbors[cell][facet];
  const std::array<std::int32_t, 3> triangle = facetOf (complex, cell, facet);
  // Two cells in a plane may share more than one facet: the vertex opposite of the right one is not on it.
  for (int k = 0; k < 3; ++k)
    if (complex.neighbors[neighbor][k] == cell &&
        std::find (triangle.begin (), triangle.end (), complex.cells[neighbor][k]) == triangle.end ())
      return k;
  return 3;
}

} // namespace manifold
} // namespace pcl
