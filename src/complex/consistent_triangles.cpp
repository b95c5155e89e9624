#include "complex/consistent_triangles.h"

#include "common/parallel.h"
#include "complex/disjoint_sets.h"

#include <algorithm>
#include <atomic>
#include <stdexcept>

namespace pcl {
namespace manifold {

namespace {

using Triangle = SimplicialComplex::Triangle;

// An edge as one of its triangles passes it.
struct Side
{
  std::uint32_t high;     // its larger vertex
  std::uint32_t triangle; // << 1 | whether the triangle passes it towards the larger vertex
};

bool
isProper (const Triangle& t, std::size_t vertices)
{
  return *std::min_element (t.begin (), t.end ()) >= 0 &&
         static_cast<std::size_t> (*std::max_element (t.begin (), t.end ())) < vertices && t[0] != t[1] &&
         t[1] != t[2] && t[2] != t[0];
}

/** The sides of all triangles in rows by the smaller vertex of their edge, each row sorted. */
class SideRows
{
public:
  SideRows (const std::vector<Triangle>& triangles, std::size_t vertices)
    : begin_ (vertices + 1), sides_ (3 * triangles.size ())
  {
    if (sides_.size () > UINT32_MAX)
      throw std::length_error ("too many triangles to number their sides");
    std::vector<std::atomic<std::uint32_t>> next (vertices);
    parallelFor (triangles.size (), [&] (std::size_t f) {
      for (int i = 0; i < 3; ++i)
        next[lowOf (triangles[f], i)].fetch_add (1, std::memory_order_relaxed);
    });
    std::uint32_t sum = 0;
    for (std::size_t v = 0; v < vertices; ++v) {
      begin_[v] = sum;
      sum += next[v].load (std::memory_order_relaxed);
      next[v].store (begin_[v], std::memory_order_relaxed);
    }
    begin_[vertices] = sum;
    parallelFor (triangles.size (), [&] (std::size_t f) {
      for (int i = 0; i < 3; ++i) {
        const auto [low, high] = std::minmax (triangles[f][i], triangles[f][(i + 1) % 3]);
        sides_[next[low].fetch_add (1, std::memory_order_relaxed)] = {
          static_cast<std::uint32_t> (high),
          static_cast<std::uint32_t> (f << 1) | static_cast<std::uint32_t> (triangles[f][i] == low)};
      }
    });
    parallelFor (vertices, [this] (std::size_t v) {
      std::sort (sides_.begin () + begin_[v], sides_.begin () + begin_[v + 1],
                 [] (const Side& a, const Side& b) {
                   return a.high != b.high ? a.high < b.high : a.triangle < b.triangle;
                 });
    });
  }

  /** Calls visit (first side, number of sides) for every edge at a vertex, its smaller one. */
  template <typename Visit>
  void forEachEdge (std::size_t vertex, const Visit& visit) const
  {
    for (std::uint32_t first = begin_[vertex], last; first < begin_[vertex + 1]; first = last) {
      last = first + 1;
      while (last < begin_[vertex + 1] && sides_[last].high == sides_[first].high)
        ++last;
      visit (&sides_[first], last - first);
    }
  }

private:
  static std::size_t lowOf (const Triangle& triangle, int i)
  {
    return static_cast<std::size_t> (std::min (triangle[i], triangle[(i + 1) % 3]));
  }

  std::vector<std::uint32_t> begin_;
  std::vector<Side> sides_;
};

} // namespace

bool
findConsistentPatches (const std::vector<Triangle>& triangles, std::size_t vertices,
                       ConsistentPatches& patches)
{
  if (triangles.size () > UINT32_MAX / 3)
    return false;
  std::atomic<bool> consistent{true};
  parallelFor (triangles.size (), [&] (std::size_t f) {
    if (!isProper (triangles[f], vertices))
      consistent.store (false, std::memory_order_relaxed);
  });
  if (!consistent)
    return false;
  const SideRows rows (triangles, vertices);
  parallelFor (vertices, [&] (std::size_t v) {
    rows.forEachEdge (v, [&] (const Side* sides, std::uint32_t count) {
      if (count == 2 && (sides[0].triangle & 1) == (sides[1].triangle & 1))
        consistent.store (false, std::memory_order_relaxed);
    });
  });
  if (!consistent)
    return false;

  DisjointSets sets (triangles.size ());
  for (std::size_t v = 0; v < vertices; ++v)
    rows.forEachEdge (v, [&] (const Side* sides, std::uint32_t count) {
      if (count == 2)
        sets.join (sides[0].triangle >> 1, sides[1].triangle >> 1);
    });
  patches.has_boundary.assign (sets.number (patches.patch), 0);
  for (std::size_t v = 0; v < vertices; ++v)
    rows.forEachEdge (v, [&] (const Side* sides, std::uint32_t count) {
      if (count == 1)
        patches.has_boundary[patches.patch[sides[0].triangle >> 1]] = 1;
    });
  return true;
}

} // namespace manifold
} // namespace pcl
