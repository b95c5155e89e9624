#include "delaunay/flat_complex.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Delaunay_triangulation_cell_base_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <algorithm>
#include <utility>

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

// Below this many samples the locks of a parallel insertion cost more than they gain.
constexpr std::int32_t PARALLEL_MIN_SAMPLES = 50000;
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
copyCells (T& triangulation, FlatCells& flat)
{
  std::vector<typename T::Cell_handle> handles;
  handles.reserve (triangulation.tds ().number_of_cells ());
  for (auto cell = triangulation.all_cells_begin (); cell != triangulation.all_cells_end (); ++cell) {
    cell->info () = static_cast<std::int32_t> (handles.size ());
    handles.push_back (cell);
  }
  const auto infinite = triangulation.infinite_vertex ();
  flat.vertices.resize (handles.size ());
  flat.neighbors.resize (handles.size ());
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
copyTriangles (T& triangulation, FlatCells& flat)
{
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
copyTriangulation (T& triangulation, FlatCells& flat)
{
  flat.affine_dimension = std::max (triangulation.dimension (), 0);
  if (flat.affine_dimension == 3)
    copyCells (triangulation, flat);
  else if (flat.affine_dimension == 2)
    copyTriangles (triangulation, flat);
  else
    flat.line = samplesAlongLine (triangulation);
}

FlatCells
triangulate (const SampleSet& samples, unsigned int threads)
{
  FlatCells flat;
  const auto points = pointsWithIndices (samples);
  if (threads > 1 && samples.size () >= PARALLEL_MIN_SAMPLES) {
    using T = Triangulation<CGAL::Parallel_tag>;
    const Eigen::Vector3d low = samples.points.rowwise ().minCoeff ();
    const Eigen::Vector3d high = samples.points.rowwise ().maxCoeff ();
    T::Lock_data_structure locks (
      CGAL::Bbox_3 (low.x (), low.y (), low.z (), high.x (), high.y (), high.z ()), LOCK_GRID);
    T triangulation;
    // CGAL 5.5 silently ignores locks that are passed to an insertion of points with info.
    triangulation.set_lock_data_structure (&locks);
    triangulation.insert (points.begin (), points.end ());
    triangulation.set_lock_data_structure (nullptr);
    copyTriangulation (triangulation, flat);
  } else {
    Triangulation<CGAL::Sequential_tag> triangulation;
    triangulation.insert (points.begin (), points.end ());
    copyTriangulation (triangulation, flat);
  }
  return flat;
}

} // namespace

std::shared_ptr<const DelaunayComplex>
computeDelaunayComplex (const std::shared_ptr<const SampleSet>& samples, unsigned int threads)
{
  return makeDelaunayComplex (samples, triangulate (*samples, threads));
}

} // namespace manifold
} // namespace pcl
