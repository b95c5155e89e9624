#pragma once

#include <pcl/manifold/delaunay_complex.h>

#include "common/index_limit.h"
#include "common/parallel.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace pcl {
namespace manifold {

/** What a Delaunay engine has to give: cells in any order, with neighbour i opposite of vertex i and positive
 * orientation (an infinite cell is positively oriented if its infinite vertex lies beyond its facet). */
struct FlatCells
{
  int affine_dimension = 0;
  std::vector<DelaunayComplex::Cell> vertices;
  std::vector<DelaunayComplex::Cell> neighbors;
  std::vector<std::int32_t> line;
};

/** The Delaunay triangulation by CGAL; the cells are the same, in another order, whether its points are
 * inserted in parallel or not.
 * \throws std::length_error if it has more cells than most_cells */
FlatCells triangulate (const SampleSet& samples, bool parallel, std::uint64_t most_cells = MOST_INDICES);

/** Brings the cells into their canonical order and adds the circumcentres and the cells at each sample. */
std::shared_ptr<const DelaunayComplex> makeDelaunayComplex (const std::shared_ptr<const SampleSet>& samples,
                                                            FlatCells flat);

} // namespace manifold
} // namespace pcl
