#pragma once

#include <pcl/manifold/export.h>
#include <pcl/manifold/sample_set.h>

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace pcl {
namespace manifold {

/** \brief The Delaunay triangulation of a sample set and its dual Voronoi diagram as flat arrays: computed
 * once, read by every method of the Delaunay family, in parallel over samples or cells without locks.
 *
 * A cell is a Delaunay tetrahedron, and so a Voronoi vertex. Every facet of the convex hull has an infinite
 * cell beside it, which stands for the unbounded Voronoi edge dual to that facet; it has the vertex
 * INFINITE_VERTEX. The finite cells come first. Vertex i of a cell is opposite of its neighbour i. The order
 * of the cells, and of the vertices in a cell, depends on the samples only.
 *
 * Samples in a plane (affine dimension 2) have no finite cell: every triangle has an infinite cell on either
 * side, and its dual Voronoi edge is the line through its circumcentre between these two. Samples on a line
 * (affine dimension 1) have no cells; the order of the samples along it is in `line`.
 * \ingroup manifold */
struct DelaunayComplex
{
  /// Stands in for the fourth vertex of an infinite cell.
  static constexpr std::int32_t INFINITE_VERTEX = -1;

  /// Four numbers of samples, or of cells.
  using Cell = std::array<std::int32_t, 4>;

  std::shared_ptr<const SampleSet> samples; ///< what was triangulated
  int affine_dimension = -1;                ///< of the samples: 0 to 3; -1 before anything was computed

  std::vector<Cell> cells;       ///< samples of each cell, positively oriented
  std::vector<Cell> neighbors;   ///< cells across the facet opposite of each vertex
  std::int32_t finite_cells = 0; ///< the number of Delaunay tetrahedra

  /// Circumcentre of each finite cell; for an infinite cell the unit normal of its hull facet that points out
  /// of the hull: the direction of the unbounded Voronoi edge.
  Eigen::Matrix3Xd centers;

  /// Samples + 1; rows of incident_cells. These are four times as many as cells: too many for 32 bits.
  std::vector<std::int64_t> incident_offsets;
  std::vector<std::int32_t> incident_cells; ///< the cells at each sample in ascending order

  std::vector<std::int32_t> line; ///< affine dimension 1: the samples in their order along the line

  /** \brief Whether a cell stands for an unbounded Voronoi edge.
   * \param[in] cell its number
   * \return true for those after the Delaunay tetrahedra */
  bool isInfinite (std::int32_t cell) const { return cell >= finite_cells; }
};

/** \brief Triangulates a sample set, with exact predicates; cospherical samples are resolved by a symbolic
 * perturbation that depends on the samples only.
 * \param[in] samples distinct finite points
 * \param[in] threads for the insertion of the points; what follows runs in the current arena. More than one
 * where that pays: small sets are inserted by one thread.
 * \return never null
 * \throws std::length_error if there are more cells than numbers of 32 bits can tell apart; std::bad_alloc
 *
 * O (n) tetrahedra and time on the samples of surfaces met in practice, O (n^2) at worst.
 * \ingroup manifold */
PCL_MANIFOLD_DELAUNAY_EXPORTS std::shared_ptr<const DelaunayComplex> computeDelaunayComplex (
  const std::shared_ptr<const SampleSet>& samples, unsigned int threads);

} // namespace manifold
} // namespace pcl
