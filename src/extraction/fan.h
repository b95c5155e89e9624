#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace pcl {
namespace manifold {

/** The link of a vertex in a set of triangles: a graph whose edges are the sides of the triangles opposite of
 * the vertex. Made for the few triangles of one vertex at a time. */
class Fan
{
public:
  void clear () { sides_.clear (); }

  void add (std::int32_t a, std::int32_t b) { sides_.emplace_back (a, b); }

  std::size_t size () const { return sides_.size (); }

  /** The component of every side, numbered from 0 in the order of their first sides; sets components. */
  const std::vector<int>& split (int& components);

  /** One path or one cycle: the triangles form one half-disk or disk. */
  bool isManifold ();

  /** No vertex is the first of two sides or the second of two: where each side was added in the order in
   * which its triangle has it, neighbouring triangles agree on a direction. */
  bool isDirected () const;

  /** Paths, or one cycle and nothing else: triangles between the paths can still make it manifold. */
  bool canBecomeManifold ();

  /** One cycle: the triangles form a disk. */
  bool isClosed () const;

  /** The two ends of a fan that is one path; -1, -1 otherwise. */
  std::array<std::int32_t, 2> ends ();

  /** How many sides end at a vertex of the link. */
  int degree (std::int32_t vertex) const;

private:
  std::vector<std::pair<std::int32_t, std::int32_t>> sides_;
  std::vector<int> component_;
  std::vector<int> stack_;
};

} // namespace manifold
} // namespace pcl
