#include "extraction/cell_coloring.h"

#include "common/parallel.h"
#include "common/parity_forest.h"
#include "extraction/spanning_forest.h"
#include "voronoi/voronoi_cell.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace pcl {
namespace manifold {

namespace {

// Wishes are granted by weight in steps of 1 / 2048, after the first step, which is for what is certain;
// within a step their order is that of cells and samples.
constexpr std::uint32_t STEPS = 4097;
constexpr std::uint16_t NO_WISH = STEPS;
static_assert (STEPS < 1U << (64 - WishKey::WISH_BITS), "a key has room for every step");
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
  const std::int32_t b = complex.neighbors[a][facet];
  const Eigen::Vector3d to_a = cell.vertex (a);
  const Eigen::Vector3d to_b = cell.vertex (b);
  // One division for two finite vertices; not the root of a product, which could overflow.
  return to_a.dot (to_b) /
         ((cell.isInfinite (a) ? 1.0 : to_a.norm ()) * (cell.isInfinite (b) ? 1.0 : to_b.norm ()));
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

/** All wishes: those below 4 * cells stand for facets, cell * 4 + facet, the others for samples. */
class Wishes
{
public:
  Wishes (const SampleDimensions& dimensions, const std::vector<Role>& roles,
          const std::vector<std::uint8_t>& together)
    : complex_ (*dimensions.complex), cells_ (complex_.cells.size ()), steps_ (4 * cells_ + roles.size ()),
      poles_ (roles.size ())
  {
    parallelFor (cells_, [&] (std::size_t i) {
      const auto cell = static_cast<std::int32_t> (i);
      for (int k = 0; k < 4; ++k) {
        const std::int32_t neighbor = complex_.neighbors[i][k];
        if (cell >= neighbor) {
          steps_[4 * i + k] = NO_WISH;
          continue;
        }
        const double depth = intersectionDepth (complex_, cell, k);
        const bool first =
          depth > FREE_SPACE_DEPTH && !together.empty () && together[i] && together[neighbor];
        steps_[4 * i + k] = stepOf (first ? CERTAIN : depth);
      }
    });
    parallelFor (roles.size (), [&] (std::size_t i) {
      if (roles[i] == Role::SURFACE)
        poles_[i] =
          findPoles (VoronoiCell (complex_, static_cast<std::int32_t> (i)), dimensions.normals.col (i));
      const Poles& poles = poles_[i];
      steps_[4 * cells_ + i] = poles.inner < 0 || poles.outer < 0      ? NO_WISH
                               : poles.opposition > CERTAIN_OPPOSITION ? stepOf (CERTAIN)
                                                                       : stepOf (poles.opposition);
    });
  }

  std::uint64_t size () const { return steps_.size (); }

  bool valid (Wish wish) const { return steps_[wish] != NO_WISH; }

  std::uint32_t step (Wish wish) const { return steps_[wish]; }

  bool opposite (Wish wish) const { return wish >= 4 * cells_; }

  std::pair<std::uint32_t, std::uint32_t> ends (Wish wish) const
  {
    if (opposite (wish)) {
      const Poles& poles = poles_[wish - 4 * cells_];
      return {static_cast<std::uint32_t> (poles.outer), static_cast<std::uint32_t> (poles.inner)};
    }
    return {static_cast<std::uint32_t> (wish >> 2),
            static_cast<std::uint32_t> (complex_.neighbors[wish >> 2][wish & 3])};
  }

  /** The facets between cells that share nearly all of their circumspheres and still got two colours, the
   * deepest first. */
  std::vector<Facet> torn (const std::vector<std::uint8_t>& colors) const
  {
    const std::uint16_t end = stepOf (FREE_SPACE_DEPTH);
    std::vector<Wish> wishes;
    for (Wish wish = 0; wish < 4 * cells_; ++wish)
      if (steps_[wish] < end && colors[wish >> 2] != colors[complex_.neighbors[wish >> 2][wish & 3]])
        wishes.push_back (wish);
    std::stable_sort (wishes.begin (), wishes.end (),
                      [this] (Wish a, Wish b) { return steps_[a] < steps_[b]; });
    std::vector<Facet> facets;
    for (const Wish wish : wishes)
      facets.push_back ({static_cast<std::int32_t> (wish >> 2), static_cast<int> (wish & 3)});
    return facets;
  }

private:
  const DelaunayComplex& complex_;
  std::size_t cells_;
  std::vector<std::uint16_t> steps_;
  std::vector<Poles> poles_;
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
  const Wishes wishes (dimensions, roles, together);
  SpanningForest<Wishes> (wishes, forest).grow ();

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
