#pragma once

#include <pcl/manifold/delaunay_complex.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace pcl {
namespace manifold {

/** The Delaunay facets around a Delaunay edge p q in their order, the infinite ones among them: between two
 * that follow each other there is a cell. */
struct EdgeRing
{
  /** The facet number `facet` of `cell`, which has p, q and `sample`, which can be the infinite vertex. */
  struct Entry
  {
    std::int32_t sample;
    std::int32_t cell;
    int facet;
  };

  std::vector<Entry> entries;

  /** \param[in] first a cell at the edge */
  void collect (const DelaunayComplex& complex, std::int32_t p, std::int32_t q, std::int32_t first)
  {
    entries.clear ();
    const auto otherVertex = [&] (std::int32_t cell, std::int32_t not_this) {
      const DelaunayComplex::Cell& vertices = complex.cells[cell];
      int k = 0;
      while (vertices[k] == p || vertices[k] == q || vertices[k] == not_this)
        ++k;
      return k;
    };
    // Every cell is left over the facet opposite of the sample of the facet that it was entered over. Cells
    // alone do not tell the facets: two cells in a plane can share more than one.
    std::int32_t cell = first;
    const std::int32_t begin = complex.cells[first][otherVertex (first, p)];
    std::int32_t behind = begin;
    do {
      const DelaunayComplex::Cell& vertices = complex.cells[cell];
      const std::int32_t sample = vertices[otherVertex (cell, behind)];
      const auto out =
        static_cast<int> (std::find (vertices.begin (), vertices.end (), behind) - vertices.begin ());
      entries.push_back ({sample, cell, out});
      cell = complex.neighbors[cell][out];
      behind = sample;
    } while (cell != first || behind != begin);
  }
};

} // namespace manifold
} // namespace pcl
