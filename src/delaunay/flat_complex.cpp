#include "delaunay/flat_complex.h"

#include "common/large_pages.h"
#include "delaunay/circumcenter.h"

#include <algorithm>
#include <atomic>
#include <numeric>

namespace pcl {
namespace manifold {

namespace {

using Cell = DelaunayComplex::Cell;

// Into how many pieces the samples are divided at most where every piece costs a look at all cells.
constexpr std::size_t MAX_PIECES = 4;
constexpr std::size_t MIN_PIECE = 10000;

bool
isInfinite (const Cell& cell)
{
  return *std::min_element (cell.begin (), cell.end ()) == DelaunayComplex::INFINITE_VERTEX;
}

std::int32_t
smallestFinite (const Cell& cell)
{
  std::int32_t smallest = INT32_MAX;
  for (const std::int32_t vertex : cell)
    if (vertex != DelaunayComplex::INFINITE_VERTEX)
      smallest = std::min (smallest, vertex);
  return smallest;
}

// Exclusive prefix sums of counts, one longer than them.
std::vector<std::int32_t>
offsetsOf (const std::vector<std::atomic<std::int32_t>>& counts)
{
  std::vector<std::int32_t> offsets (counts.size () + 1, 0);
  for (std::size_t i = 0; i < counts.size (); ++i)
    offsets[i + 1] = offsets[i] + counts[i].load (std::memory_order_relaxed);
  return offsets;
}

// The even permutation of the positions of a cell that depends on its vertices and its orientation only: the
// smallest vertex first, the smallest that can follow next, and an infinite vertex last.
std::array<int, 4>
canonicalPositions (const Cell& cell)
{
  static constexpr int FIRST[4][4] = {{0, 1, 2, 3}, {1, 0, 3, 2}, {2, 3, 0, 1}, {3, 2, 1, 0}};
  // As unsigned numbers the infinite vertex is the largest.
  const auto key = [&cell] (int position) { return static_cast<std::uint32_t> (cell[position]); };
  int smallest = 0;
  for (int k = 1; k < 4; ++k)
    if (key (k) < key (smallest))
      smallest = k;
  const int* p = FIRST[smallest];
  std::array<int, 4> result{p[0], p[1], p[2], p[3]};
  if (key (p[2]) < key (p[1]) && key (p[2]) < key (p[3]))
    result = {p[0], p[2], p[3], p[1]};
  else if (key (p[3]) < key (p[1]) && key (p[3]) < key (p[2]))
    result = {p[0], p[3], p[1], p[2]};
  if (cell[result[2]] == DelaunayComplex::INFINITE_VERTEX)
    result = {result[1], result[0], result[3], result[2]};
  return result;
}

// A cell with its vertices in canonical order, and its number in the engine's order.
struct OrderedCell
{
  Cell vertices;
  std::int32_t number;
};

Cell
permuted (const Cell& cell, const std::array<int, 4>& positions)
{
  return {cell[positions[0]], cell[positions[1]], cell[positions[2]], cell[positions[3]]};
}

// The cells in canonical order: finite ones first, each kind by its vertices.
std::vector<OrderedCell>
canonicalOrder (const std::vector<Cell>& cells, std::int32_t samples)
{
  // Bucket v: finite cells whose smallest vertex is v, and in the second half likewise the infinite ones.
  std::vector<std::atomic<std::int32_t>> counts (2 * static_cast<std::size_t> (samples));
  const auto bucketOf = [&] (const Cell& cell) {
    return static_cast<std::size_t> (smallestFinite (cell)) +
           (isInfinite (cell) ? static_cast<std::size_t> (samples) : 0);
  };
  parallelFor (cells.size (),
               [&] (std::size_t i) { counts[bucketOf (cells[i])].fetch_add (1, std::memory_order_relaxed); });
  const std::vector<std::int32_t> offsets = offsetsOf (counts);
  std::vector<OrderedCell> order;
  assignLarge (order, cells.size ());
  parallelFor (cells.size (), [&] (std::size_t i) {
    const std::size_t bucket = bucketOf (cells[i]);
    order[offsets[bucket] + counts[bucket].fetch_sub (1, std::memory_order_relaxed) - 1] = {
      permuted (cells[i], canonicalPositions (cells[i])), static_cast<std::int32_t> (i)};
  });
  parallelFor (counts.size (), [&] (std::size_t bucket) {
    std::sort (order.begin () + offsets[bucket], order.begin () + offsets[bucket + 1],
               [] (const OrderedCell& x, const OrderedCell& y) { return x.vertices < y.vertices; });
  });
  return order;
}

void
orderCells (const FlatCells& flat, DelaunayComplex& complex)
{
  const std::vector<OrderedCell> order = canonicalOrder (flat.vertices, complex.samples->size ());
  std::vector<std::int32_t> new_number;
  assignLarge (new_number, order.size ());
  assignLarge (complex.cells, order.size ());
  parallelFor (order.size (), [&] (std::size_t i) {
    complex.cells[i] = order[i].vertices;
    new_number[order[i].number] = static_cast<std::int32_t> (i);
  });
  assignLarge (complex.neighbors, order.size ());
  parallelFor (order.size (), [&] (std::size_t i) {
    const std::int32_t old = order[i].number;
    complex.neighbors[i] = permuted (flat.neighbors[old], canonicalPositions (flat.vertices[old]));
    for (std::int32_t& neighbor : complex.neighbors[i])
      neighbor = new_number[neighbor];
  });
  const auto first_infinite = std::partition_point (complex.cells.begin (), complex.cells.end (),
                                                    [] (const Cell& cell) { return !isInfinite (cell); });
  complex.finite_cells = static_cast<std::int32_t> (first_infinite - complex.cells.begin ());
}

void
computeCenters (DelaunayComplex& complex)
{
  const Eigen::Matrix3Xd& points = complex.samples->points;
  resizeLarge (complex.centers, 3, static_cast<Eigen::Index> (complex.cells.size ()));
  parallelFor (complex.cells.size (), [&] (std::size_t i) {
    const Cell& cell = complex.cells[i];
    const Eigen::Vector3d a = points.col (cell[0]);
    const Eigen::Vector3d b = points.col (cell[1]);
    const Eigen::Vector3d c = points.col (cell[2]);
    if (complex.isInfinite (static_cast<std::int32_t> (i)))
      complex.centers.col (i) = unitNormal (a, b, c);
    else
      complex.centers.col (i) = circumcenter (a, b, c, points.col (cell[3]));
  });
}

void
collectIncidentCells (DelaunayComplex& complex)
{
  // Plain counting, in order: atomic counters, with a sort afterwards, take longer than one thread without
  // them. Each of a few pieces of the samples reads all cells.
  const auto samples = static_cast<std::size_t> (complex.samples->size ());
  const std::size_t pieces = std::min<std::size_t> (MAX_PIECES, samples / MIN_PIECE + 1);
  const auto forPiece = [&] (std::size_t piece, const auto& body) {
    const auto begin = static_cast<std::int32_t> (samples * piece / pieces);
    const auto end = static_cast<std::int32_t> (samples * (piece + 1) / pieces);
    for (std::size_t i = 0; i < complex.cells.size (); ++i)
      for (const std::int32_t vertex : complex.cells[i])
        if (vertex >= begin && vertex < end)
          body (vertex, static_cast<std::int32_t> (i));
  };
  std::vector<std::int64_t>& offsets = complex.incident_offsets;
  offsets.assign (samples + 1, 0);
  parallelFor (
    pieces,
    [&] (std::size_t piece) { forPiece (piece, [&] (std::int32_t v, std::int32_t) { ++offsets[v + 1]; }); },
    1);
  std::partial_sum (offsets.begin (), offsets.end (), offsets.begin ());
  assignLarge (complex.incident_cells, static_cast<std::size_t> (offsets.back ()));
  std::vector<std::int64_t> next (offsets.begin (), offsets.end () - 1);
  parallelFor (
    pieces,
    [&] (std::size_t piece) {
      forPiece (piece, [&] (std::int32_t v, std::int32_t cell) { complex.incident_cells[next[v]++] = cell; });
    },
    1);
}

} // namespace

std::shared_ptr<const DelaunayComplex>
makeDelaunayComplex (const std::shared_ptr<const SampleSet>& samples, FlatCells flat)
{
  auto complex = std::make_shared<DelaunayComplex> ();
  complex->samples = samples;
  complex->affine_dimension = flat.affine_dimension;
  complex->line = std::move (flat.line);
  orderCells (flat, *complex);
  flat = FlatCells ();
  computeCenters (*complex);
  collectIncidentCells (*complex);
  return complex;
}

} // namespace manifold
} // namespace pcl
