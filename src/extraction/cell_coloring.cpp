#include "extraction/cell_coloring.h"

#include "common/parallel.h"
#include "extraction/parity_forest.h"
#include "voronoi/voronoi_cell.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace pcl {
namespace manifold {

namespace {

// Wishes are sorted by weight in steps of 1 / 2048, after the first step, which is for what is certain;
// within a step their order is that of cells and samples.
constexpr std::uint32_t STEPS = 4097;
constexpr std::uint16_t NO_WISH = STEPS;
// Poles this nearly opposite (8 degrees) of each other are certain to be on two sides: that comes before
// everything else, or the two sides of a one-sided surface, being one and the same, would get one colour.
constexpr double CERTAIN_OPPOSITION = 0.99;
// Circumspheres that intersect at less than 8 degrees: no surface passes between them.
constexpr double FREE_SPACE_DEPTH = 0.99;
constexpr double CERTAIN = 3.0; // a weight that falls into the first step

// The step of a weight in [-1, 1], the largest weight first; CERTAIN comes before all of them.
std::uint16_t
stepOf (double weight)
{
  const double step = 1.0 + (1.0 - weight) * 0.5 * (STEPS - 1);
  return static_cast<std::uint16_t> (std::clamp (step, 0.0, static_cast<double> (STEPS - 1)));
}

// Unit vector from a sample to a Voronoi vertex of its cell.
Eigen::Vector3d
directionTo (const VoronoiCell& cell, std::int32_t vertex)
{
  return cell.isInfinite (vertex) ? cell.vertex (vertex)
                                  : Eigen::Vector3d (cell.vertex (vertex).normalized ());
}

// How deeply the circumspheres of the two cells at a facet intersect: the cosine of the angle at which they
// do, 1 where they are the same.
double
intersectionDepth (const DelaunayComplex& complex, std::int32_t a, int facet)
{
  const DelaunayComplex::Cell& vertices = complex.cells[a];
  int k = facet == 0 ? 1 : 0;
  while (k == facet || vertices[k] == DelaunayComplex::INFINITE_VERTEX)
    ++k;
  const VoronoiCell cell (complex, vertices[k]);
  return directionTo (cell, a).dot (directionTo (cell, complex.neighbors[a][facet]));
}

struct Poles
{
  std::int32_t outer = -1;
  std::int32_t inner = -1;
  double opposition = -1.0; // minus the cosine of the angle between them
};

// The farthest Voronoi vertices on either side of a surface sample.
Poles
findPoles (const VoronoiCell& cell, const Eigen::Vector3d& normal)
{
  Poles poles;
  double outer_distance = -1.0;
  double inner_distance = -1.0;
  for (const std::int32_t vertex : cell) {
    const Eigen::Vector3d v = cell.vertex (vertex);
    const double side = v.dot (normal);
    // Every infinite vertex is farther than any other; among them the one nearest to the normal.
    const double distance = cell.isInfinite (vertex)
                              ? std::numeric_limits<double>::max () * (0.5 + 0.25 * std::abs (side))
                              : v.squaredNorm ();
    if (side > 0.0 && distance > outer_distance) {
      outer_distance = distance;
      poles.outer = vertex;
    } else if (side < 0.0 && distance > inner_distance) {
      inner_distance = distance;
      poles.inner = vertex;
    }
  }
  if (poles.outer >= 0 && poles.inner >= 0)
    poles.opposition = -directionTo (cell, poles.outer).dot (directionTo (cell, poles.inner));
  return poles;
}

/** All wishes, sorted: numbers below 4 * cells stand for facets, cell * 4 + facet, the others for samples. */
class Wishes
{
public:
  Wishes (const SampleDimensions& dimensions, const std::vector<Role>& roles,
          const std::vector<std::uint8_t>& together)
    : complex_ (*dimensions.complex), cells_ (complex_.cells.size ()), poles_ (roles.size ())
  {
    std::vector<std::uint16_t> steps (4 * cells_ + roles.size (), NO_WISH);
    parallelFor (cells_, [&] (std::size_t i) {
      const auto cell = static_cast<std::int32_t> (i);
      for (int k = 0; k < 4; ++k)
        if (cell < complex_.neighbors[i][k]) {
          const double depth = intersectionDepth (complex_, cell, k);
          const bool first = depth > FREE_SPACE_DEPTH && !together.empty () && together[i] &&
                             together[complex_.neighbors[i][k]];
          steps[4 * i + k] = stepOf (first ? CERTAIN : depth);
        }
    });
    parallelFor (roles.size (), [&] (std::size_t i) {
      if (roles[i] != Role::SURFACE)
        return;
      poles_[i] =
        findPoles (VoronoiCell (complex_, static_cast<std::int32_t> (i)), dimensions.normals.col (i));
      if (poles_[i].inner >= 0 && poles_[i].outer >= 0)
        steps[4 * cells_ + i] =
          stepOf (poles_[i].opposition > CERTAIN_OPPOSITION ? CERTAIN : poles_[i].opposition);
    });
    sort (steps);
  }

  /** Grants the wishes in their order, as far as those before allow. Few of the later ones join anything:
   * before each of the growing pieces the others are sorted out in parallel. */
  void grant (ParityForest& forest)
  {
    deep_.assign (order_.begin (), order_.begin () + static_cast<std::ptrdiff_t> (deep_end_));
    std::size_t begin = 0;
    for (const std::size_t share : {16, 8, 4, 2, 1}) {
      const std::size_t end = order_.size () / share;
      if (begin > 0) {
        forest.compress ();
        parallelFor (end - begin, [&] (std::size_t i) {
          std::uint32_t& wish = order_[begin + i];
          const auto [a, b] = cellsOf (wish);
          if (forest.look (a).first == forest.look (b).first)
            wish = GRANTED;
        });
      }
      for (std::size_t i = begin; i < end; ++i)
        if (order_[i] != GRANTED) {
          const auto [a, b] = cellsOf (order_[i]);
          forest.unite (a, b, order_[i] >= 4 * cells_);
        }
      begin = end;
    }
  }

  /** The facets between cells that share nearly all of their circumspheres and still got two colours. */
  std::vector<Facet> torn (const std::vector<std::uint8_t>& colors) const
  {
    std::vector<Facet> facets;
    for (const std::uint32_t wish : deep_)
      if (wish < 4 * cells_) {
        const auto [a, b] = cellsOf (wish);
        if (colors[a] != colors[b])
          facets.push_back ({static_cast<std::int32_t> (a), static_cast<int> (wish & 3)});
      }
    return facets;
  }

private:
  static constexpr std::uint32_t GRANTED = UINT32_MAX;

  std::pair<std::uint32_t, std::uint32_t> cellsOf (std::uint32_t wish) const
  {
    if (wish >= 4 * cells_) {
      const Poles& poles = poles_[wish - 4 * cells_];
      return {static_cast<std::uint32_t> (poles.outer), static_cast<std::uint32_t> (poles.inner)};
    }
    return {wish >> 2, static_cast<std::uint32_t> (complex_.neighbors[wish >> 2][wish & 3])};
  }

  // A counting sort in parallel pieces, stable and so the same for any number of threads.
  void sort (const std::vector<std::uint16_t>& steps)
  {
    constexpr std::size_t PIECES = 64;
    const std::size_t piece_size = steps.size () / PIECES + 1;
    std::vector<std::uint32_t> counts (PIECES * STEPS, 0);
    const auto forPiece = [&] (std::size_t piece, const auto& body) {
      const std::size_t end = std::min (steps.size (), (piece + 1) * piece_size);
      for (std::size_t i = piece * piece_size; i < end; ++i)
        if (steps[i] != NO_WISH)
          body (i);
    };
    parallelFor (
      PIECES,
      [&] (std::size_t piece) {
        forPiece (piece, [&] (std::size_t i) { ++counts[piece * STEPS + steps[i]]; });
      },
      1);
    std::uint32_t sum = 0;
    for (std::size_t step = 0; step < STEPS; ++step) {
      if (step == stepOf (FREE_SPACE_DEPTH))
        deep_end_ = sum;
      for (std::size_t piece = 0; piece < PIECES; ++piece) {
        const std::uint32_t count = counts[piece * STEPS + step];
        counts[piece * STEPS + step] = sum;
        sum += count;
      }
    }
    order_.resize (sum);
    parallelFor (
      PIECES,
      [&] (std::size_t piece) {
        forPiece (piece, [&] (std::size_t i) {
          order_[counts[piece * STEPS + steps[i]]++] = static_cast<std::uint32_t> (i);
        });
      },
      1);
  }

  const DelaunayComplex& complex_;
  std::size_t cells_;
  std::vector<Poles> poles_;
  std::vector<std::uint32_t> order_;
  std::vector<std::uint32_t> deep_; // the wishes of cells that share nearly all of their circumspheres
  std::size_t deep_end_ = 0;
};

} // namespace

CellColors
colorCells (const SampleDimensions& dimensions, const std::vector<Role>& roles,
            const std::vector<std::uint8_t>& solid, bool closed, const std::vector<std::uint8_t>& together)
{
  const DelaunayComplex& complex = *dimensions.complex;
  const auto cells = static_cast<std::uint32_t> (complex.cells.size ());
  const auto first_infinite = static_cast<std::uint32_t> (complex.finite_cells);
  ParityForest forest (cells);
  // What is certain: the outside is one, and so is the inside of a solid.
  if (closed)
    for (std::uint32_t cell = first_infinite + 1; cell < cells; ++cell)
      forest.unite (first_infinite, cell, false);
  for (std::uint32_t cell = 0; cell < first_infinite; ++cell)
    for (int k = 0; solid[cell] && k < 4; ++k)
      if (solid[complex.neighbors[cell][k]])
        forest.unite (cell, static_cast<std::uint32_t> (complex.neighbors[cell][k]), false);
  Wishes wishes (dimensions, roles, together);
  wishes.grant (forest);

  CellColors result;
  result.colors.resize (cells);
  forest.compress ();
  const std::uint32_t reference = forest.look (first_infinite).second;
  parallelFor (cells, [&] (std::size_t cell) {
    result.colors[cell] =
      static_cast<std::uint8_t> (forest.look (static_cast<std::uint32_t> (cell)).second ^ reference);
  });
  result.torn = wishes.torn (result.colors);
  return result;
}

} // namespace manifold
} // namespace pcl
