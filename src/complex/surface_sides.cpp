#include "complex/surface_sides.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace pcl {
namespace manifold {

namespace {

/** \brief Does a face pass an edge twice, or go from a vertex to itself? */
bool
passesTwice (const pcl::index_t* row, std::size_t size)
{
  std::vector<std::pair<pcl::index_t, pcl::index_t>> sides;
  for (std::size_t i = 0; i < size; ++i)
    sides.push_back (std::minmax ({row[i], row[i + 1 < size ? i + 1 : 0]}));
  std::sort (sides.begin (), sides.end ());
  return std::adjacent_find (sides.begin (), sides.end ()) != sides.end () ||
         std::any_of (sides.begin (), sides.end (),
                      [] (const auto& side) { return side.first == side.second; });
}

/** \brief Is a row no face? \a sorted is scratch space and holds the row's vertices in order afterwards. */
bool
isDegenerate (const pcl::index_t* row, std::size_t size, std::size_t index_end, pcl::Indices& sorted)
{
  sorted.assign (row, row + size);
  std::sort (sorted.begin (), sorted.end ());
  return size < 3 || sorted.front () < 0 || static_cast<std::size_t> (sorted.back ()) >= index_end ||
         (std::adjacent_find (sorted.begin (), sorted.end ()) != sorted.end () && passesTwice (row, size));
}

} // namespace

SurfaceSides::SurfaceSides (const FaceRows& faces, std::size_t index_end)
{
  if (faces.vertices.size () >= non_manifold)
    throw std::length_error ("too many faces for one surface");
  takeFaces (faces, index_end);
  groupSides ();
}

void
SurfaceSides::takeFaces (const FaceRows& faces, std::size_t index_end)
{
  starts.reserve (faces.size () + 1);
  source.reserve (faces.size ());
  face.reserve (faces.vertices.size ());
  starts.push_back (0);
  pcl::Indices kept;
  kept.reserve (faces.vertices.size ());
  pcl::Indices sorted;
  for (std::size_t f = 0; f < faces.size (); ++f) {
    const pcl::index_t* row = faces.vertices.data () + faces.starts[f];
    const std::size_t size = faces.starts[f + 1] - faces.starts[f];
    if (isDegenerate (row, size, index_end, sorted)) {
      ++degenerate_faces;
      continue;
    }
    kept.insert (kept.end (), row, row + size);
    face.insert (face.end (), size, static_cast<Index> (source.size ()));
    source.push_back (static_cast<Index> (f));
    starts.push_back (static_cast<Index> (kept.size ()));
  }

  const VertexNumbering numbering ({kept});
  vertices = numbering.size ();
  origin.resize (kept.size ());
  std::transform (kept.begin (), kept.end (), origin.begin (), [&] (pcl::index_t v) { return numbering[v]; });
}

void
SurfaceSides::groupSides ()
{
  // Sides go into buckets by the smaller vertex of their edge (a counting sort). A bucket holds the sides
  // around one vertex, a handful, and is sorted by the larger vertex.
  const auto sides = static_cast<Index> (origin.size ());
  std::vector<Index> bucket_starts (vertices + 1, 0);
  for (Index s = 0; s < sides; ++s)
    ++bucket_starts[std::min (origin[s], origin[next (s)])];
  Index total = 0;
  for (Index& start : bucket_starts) {
    const Index count = start;
    start = total;
    total += count;
  }
  std::vector<std::uint64_t> keys (sides); // larger vertex, side
  std::vector<Index> fill (bucket_starts.begin (), bucket_starts.end () - 1);
  for (Index s = 0; s < sides; ++s) {
    const auto [low, high] = std::minmax (origin[s], origin[next (s)]);
    keys[fill[low]++] = static_cast<std::uint64_t> (high) << 32 | s;
  }

  twin.resize (sides);
  edge_sides.resize (sides);
  edge_starts.reserve (sides / 2 + 1);
  for (std::size_t v = 0; v < vertices; ++v) {
    const Index end = bucket_starts[v + 1];
    std::sort (keys.begin () + bucket_starts[v], keys.begin () + end);
    for (Index first = bucket_starts[v], last; first < end; first = last) {
      last = first;
      while (last < end && keys[last] >> 32 == keys[first] >> 32) {
        edge_sides[last] = static_cast<Index> (keys[last]);
        ++last;
      }
      edge_starts.push_back (first);
      for (Index i = first; i < last; ++i)
        twin[edge_sides[i]] = last - first == 1   ? border
                              : last - first == 2 ? edge_sides[first + last - 1 - i]
                                                  : non_manifold;
    }
  }
  edge_starts.push_back (sides);
}

FaceRows
toFaceRows (const std::vector<SimplicialComplex::Triangle>& triangles)
{
  FaceRows faces;
  faces.starts.resize (triangles.size () + 1);
  for (std::size_t i = 0; i < faces.starts.size (); ++i)
    faces.starts[i] = 3 * i;
  const IndexSpan span (triangles);
  faces.vertices.assign (span.data, span.data + span.size);
  return faces;
}

} // namespace manifold
} // namespace pcl
