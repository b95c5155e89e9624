#include "common/large_pages.h"
#include "delaunay/flat_complex.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Delaunay_triangulation_cell_base_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <tbb/scalable_allocator.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <new>
#include <random>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

// The only place where CGAL's triangulations are known: everything else reads the flat arrays.

namespace pcl {
namespace manifold {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_3<std::int32_t, Kernel>;
using CellBase = CGAL::Triangulation_cell_base_with_info_3<std::int32_t, Kernel,
                                                           CGAL::Delaunay_triangulation_cell_base_3<Kernel>>;

template <typename ConcurrencyTag>
using Triangulation =
  CGAL::Delaunay_triangulation_3<Kernel,
                                 CGAL::Triangulation_data_structure_3<VertexBase, CellBase, ConcurrencyTag>>;

// Below this many samples there is too little to gain from a parallel insertion to try it out.
constexpr std::int32_t PARALLEL_MIN_SAMPLES = 200000;
// The two kinds of insertion are tried out on this share of the samples, and on no fewer than these, next to
// each other.
constexpr std::size_t TRIAL_SHARE = 60;
constexpr std::size_t TRIAL_MIN_SAMPLES = 10000;
// Cells per axis of the grid of locks, as in CGAL's manual.
constexpr int LOCK_GRID = 50;

std::vector<std::pair<Kernel::Point_3, std::int32_t>>
pointsWithIndices (const SampleSet& samples)
{
  std::vector<std::pair<Kernel::Point_3, std::int32_t>> points;
  points.reserve (static_cast<std::size_t> (samples.size ()));
  for (std::int32_t i = 0; i < samples.size (); ++i) {
    const auto p = samples.points.col (i);
    points.emplace_back (Kernel::Point_3 (p.x (), p.y (), p.z ()), i);
  }
  return points;
}

// Affine dimension 3: every cell, with INFINITE_VERTEX for CGAL's infinite vertex.
template <typename T>
void
copyCells (T& triangulation, std::uint64_t most_cells, FlatCells& flat)
{
  requireIndices (triangulation.tds ().number_of_cells (), "Delaunay cells", most_cells);
  std::vector<typename T::Cell_handle> handles;
  handles.reserve (triangulation.tds ().number_of_cells ());
  for (auto cell = triangulation.all_cells_begin (); cell != triangulation.all_cells_end (); ++cell) {
    cell->info () = static_cast<std::int32_t> (handles.size ());
    handles.push_back (cell);
  }
  const auto infinite = triangulation.infinite_vertex ();
  assignLarge (flat.vertices, handles.size ());
  assignLarge (flat.neighbors, handles.size ());
  parallelFor (handles.size (), [&] (std::size_t i) {
    for (int k = 0; k < 4; ++k) {
      const auto vertex = handles[i]->vertex (k);
      flat.vertices[i][k] = vertex == infinite ? DelaunayComplex::INFINITE_VERTEX : vertex->info ();
      flat.neighbors[i][k] = handles[i]->neighbor (k)->info ();
    }
  });
}

// Affine dimension 2: an infinite cell on either side of every triangle.
template <typename T>
void
copyTriangles (T& triangulation, std::uint64_t most_cells, FlatCells& flat)
{
  requireIndices (2 * static_cast<std::uint64_t> (triangulation.number_of_finite_facets ()), "Delaunay cells",
                  most_cells);
  std::vector<typename T::Cell_handle> handles;
  for (auto facet = triangulation.finite_facets_begin (); facet != triangulation.finite_facets_end ();
       ++facet) {
    facet->first->info () = static_cast<std::int32_t> (handles.size ());
    handles.push_back (facet->first);
  }
  const auto infinite = triangulation.infinite_vertex ();
  for (const auto& handle : handles) {
    const auto self = static_cast<std::int32_t> (flat.vertices.size ());
    for (int side = 0; side < 2; ++side) {
      DelaunayComplex::Cell vertices{};
      DelaunayComplex::Cell neighbors{};
      for (int k = 0; k < 3; ++k) {
        vertices[k] = handle->vertex (k)->info ();
        const auto across = handle->neighbor (k);
        // At the rim of the hull one side of the plane goes over into the other.
        neighbors[k] = across->has_vertex (infinite) ? self + 1 - side : 2 * across->info () + side;
      }
      vertices[3] = DelaunayComplex::INFINITE_VERTEX;
      neighbors[3] = self + 1 - side;
      if (side == 1) {
        std::swap (vertices[0], vertices[1]);
        std::swap (neighbors[0], neighbors[1]);
      }
      flat.vertices.push_back (vertices);
      flat.neighbors.push_back (neighbors);
    }
  }
}

// Affine dimension 0 and 1.
template <typename T>
std::vector<std::int32_t>
samplesAlongLine (const T& triangulation)
{
  std::vector<std::pair<Kernel::Point_3, std::int32_t>> points;
  for (auto vertex = triangulation.finite_vertices_begin (); vertex != triangulation.finite_vertices_end ();
       ++vertex)
    points.emplace_back (vertex->point (), vertex->info ());
  std::sort (points.begin (), points.end ()); // on a line the lexicographic order is the order along it
  std::vector<std::int32_t> line;
  for (const auto& point : points)
    line.push_back (point.second);
  return line;
}

template <typename T>
void
copyTriangulation (T& triangulation, std::uint64_t most_cells, FlatCells& flat)
{
  flat.affine_dimension = std::max (triangulation.dimension (), 0);
  if (flat.affine_dimension == 3)
    copyCells (triangulation, most_cells, flat);
  else if (flat.affine_dimension == 2)
    copyTriangles (triangulation, most_cells, flat);
  else
    flat.line = samplesAlongLine (triangulation);
}

using Points = std::vector<std::pair<Kernel::Point_3, std::int32_t>>;

// CGAL keeps the facets around the point that it inserts in a variable of the thread (vertex_pair_facet_map).
// An allocation that fails leaves them there, and the next insertion by the same thread would read them. So
// once an insertion has thrown, no other one runs in a thread that may have taken part.
std::atomic<bool> insertion_has_thrown{false};

// Runs body () in a thread of its own.
template <typename Body>
void
inFreshThread (const Body& body)
{
  std::exception_ptr thrown;
  try {
    std::thread thread ([&] {
      try {
        body ();
      } catch (...) {
        thrown = std::current_exception ();
      }
    });
    thread.join ();
  } catch (const std::system_error&) {
    throw std::bad_alloc (); // no room for another thread
  }
  if (thrown)
    std::rethrow_exception (thrown);
}

// Runs insert (), and remembers if it throws.
template <typename Insert>
void
watched (const Insert& insert)
{
  try {
    insert ();
  } catch (...) {
    insertion_has_thrown = true;
    throw;
  }
}

// Gives the memory of a triangulation that was made in parallel back to the system: TBB's allocator would
// keep it.
struct MemoryReturn
{
  MemoryReturn () = default;
  MemoryReturn (const MemoryReturn&) = delete;
  MemoryReturn& operator= (const MemoryReturn&) = delete;

  ~MemoryReturn () { scalable_allocation_command (TBBMALLOC_CLEAN_ALL_BUFFERS, nullptr); }
};

// Inserts points into a triangulation, and hands it to use (triangulation).
template <typename Use>
void
insertInParallel (const Points& points, const Use& use)
{
  using T = Triangulation<CGAL::Parallel_tag>;
  CGAL::Bbox_3 box;
  for (const auto& point : points)
    box += point.first.bbox ();
  T::Lock_data_structure locks (box, LOCK_GRID);
  const MemoryReturn after_triangulation;
  T triangulation;
  // CGAL 5.5 silently ignores locks that are passed to an insertion of points with info.
  triangulation.set_lock_data_structure (&locks);
  watched ([&] { triangulation.insert (points.begin (), points.end ()); });
  triangulation.set_lock_data_structure (nullptr);
  use (triangulation);
}

// A random share of the points before the rest, and so on down to a few, each share in the order of the
// samples, along their space-filling curve: a biased randomized insertion order (Amenta, Choi, Rote).
std::vector<std::int32_t>
insertionOrder (std::size_t points)
{
  constexpr unsigned int SHARE = 32;
  constexpr std::size_t FEW = 64;
  std::vector<std::vector<std::int32_t>> rounds (1);
  for (std::size_t n = points; n > FEW; n /= SHARE)
    rounds.emplace_back ();
  std::mt19937 random (1);
  for (std::size_t i = 0; i < points; ++i) {
    std::size_t round = 0;
    while (round + 1 < rounds.size () && random () % SHARE == 0)
      ++round;
    rounds[round].push_back (static_cast<std::int32_t> (i));
  }
  std::vector<std::int32_t> order;
  order.reserve (points);
  for (auto round = rounds.rbegin (); round != rounds.rend (); ++round)
    order.insert (order.end (), round->begin (), round->end ());
  return order;
}

// The points lie along a space-filling curve already: CGAL's own insertion of a range would sort them again.
template <typename Use>
void
insertInSequence (const Points& points, const Use& use)
{
  using T = Triangulation<CGAL::Sequential_tag>;
  T triangulation;
  const auto insert = [&] {
    typename T::Cell_handle hint;
    for (const std::int32_t i : insertionOrder (points.size ())) {
      const auto vertex = triangulation.insert (points[i].first, hint);
      vertex->info () = points[i].second;
      hint = vertex->cell ();
    }
  };
  if (insertion_has_thrown)
    inFreshThread (insert);
  else
    watched (insert);
  use (triangulation);
}

template <typename Insert>
double
secondsOf (const Insert& insert)
{
  const auto start = std::chrono::steady_clock::now ();
  insert ();
  return std::chrono::duration<double> (std::chrono::steady_clock::now () - start).count ();
}

// The parallel insertion gains up to a half on noisy samples and loses as much, or far more on a busy
// machine, on clean ones, whose large empty spheres make the threads wait for each other. The result is the
// same, so it is tried out on a few samples.
bool
parallelPays (const Points& points)
{
  const auto begin = points.begin () + static_cast<std::ptrdiff_t> (points.size () / 2);
  const Points trial (
    begin, begin + static_cast<std::ptrdiff_t> (std::max (points.size () / TRIAL_SHARE, TRIAL_MIN_SAMPLES)));
  const auto ignore = [] (const auto&) {};
  const double sequential = secondsOf ([&] { insertInSequence (trial, ignore); });
  return secondsOf ([&] { insertInParallel (trial, ignore); }) < sequential;
}

} // namespace

FlatCells
triangulate (const SampleSet& samples, bool parallel, std::uint64_t most_cells)
{
  FlatCells flat;
  const Points points = pointsWithIndices (samples);
  const auto copy = [&flat, most_cells] (auto& triangulation) {
    copyTriangulation (triangulation, most_cells, flat);
  };
  if (parallel)
    insertInParallel (points, copy);
  else
    insertInSequence (points, copy);
  return flat;
}

std::shared_ptr<const DelaunayComplex>
computeDelaunayComplex (const std::shared_ptr<const SampleSet>& samples, unsigned int threads)
{
  const bool parallel = threads > 1 && samples->size () >= PARALLEL_MIN_SAMPLES && !insertion_has_thrown &&
                        parallelPays (pointsWithIndices (*samples));
  return makeDelaunayComplex (samples, triangulate (*samples, parallel));
}

} // namespace manifold
} // namespace pcl
