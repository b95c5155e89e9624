#include "graph/faces/face_cutter.h"

#include <algorithm>
#include <cmath>

namespace pcl {
namespace manifold {

namespace {

// All ways to cut a face are compared up to this length; longer ones are shortened by such pieces first.
constexpr std::size_t LONGEST_PIECE = 24;

// A diagonal that is an edge already, or that joins a landmark with itself, is worse than any other ones.
constexpr double FORBIDDEN = 1e100;

std::uint64_t
key (pcl::index_t a, pcl::index_t b)
{
  return static_cast<std::uint64_t> (std::min (a, b)) << 32 | static_cast<std::uint64_t> (std::max (a, b));
}

} // namespace

FaceCutter::FaceCutter (const LandmarkMesh& mesh, const Eigen::Ref<const Eigen::MatrixXd>& points)
  : points_ (points)
{
  for (const LandmarkMesh::Edge& edge : mesh.edges)
    addEdge (edge[0], edge[1]);
}

bool
FaceCutter::canCut (const Walk& face)
{
  if (face.size () > LONGEST_PIECE)
    return true;
  compareAll (face);
  return costs_[face.size () - 1] < FORBIDDEN;
}

void
FaceCutter::cut (Walk face, std::vector<Triangle>& triangles)
{
  while (face.size () > LONGEST_PIECE) {
    // The first landmarks of the face, but for the very first one, are left behind.
    cutPiece ({face.begin (), face.begin () + LONGEST_PIECE}, triangles);
    addEdge (face[0], face[LONGEST_PIECE - 1]);
    face.erase (face.begin () + 1, face.begin () + LONGEST_PIECE - 1);
  }
  cutPiece (face, triangles);
}

void
FaceCutter::addEdge (pcl::index_t a, pcl::index_t b)
{
  if (edges_.insert (key (a, b)).second) {
    ++degrees_[a];
    ++degrees_[b];
  }
}

// Without coordinates those are preferred that make the landmarks' numbers of edges alike.
double
FaceCutter::cost (pcl::index_t a, pcl::index_t b) const
{
  if (a == b || edges_.count (key (a, b)) > 0)
    return FORBIDDEN;
  if (points_.cols () > 0)
    return (points_.col (a) - points_.col (b)).norm ();
  return std::pow (degrees_.at (a), 2) + std::pow (degrees_.at (b), 2);
}

// The cheapest triangulation of every part of the piece that one diagonal cuts off, from small to large.
void
FaceCutter::compareAll (const Walk& piece)
{
  const std::size_t size = piece.size ();
  costs_.assign (size * size, 0.0);
  apex_.assign (size * size, 0);
  for (std::size_t span = 2; span < size; ++span)
    for (std::size_t i = 0; i + span < size; ++i) {
      const std::size_t j = i + span;
      double best = -1.0;
      for (std::size_t k = i + 1; k < j; ++k) {
        const double total = costs_[i * size + k] + costs_[k * size + j];
        if (best < 0.0 || total < best) {
          best = total;
          apex_[i * size + j] = k;
        }
      }
      costs_[i * size + j] = best + (span + 1 < size ? cost (piece[i], piece[j]) : 0.0);
    }
}

void
FaceCutter::cutPiece (const Walk& piece, std::vector<Triangle>& triangles)
{
  compareAll (piece);
  const std::size_t size = piece.size ();
  parts_.assign (1, {0, size - 1});
  while (!parts_.empty ()) {
    const auto [i, j] = parts_.back ();
    parts_.pop_back ();
    if (j < i + 2)
      continue;
    const std::size_t k = apex_[i * size + j];
    const Triangle triangle{piece[i], piece[k], piece[j]};
    if (triangle[0] != triangle[1] && triangle[1] != triangle[2] && triangle[2] != triangle[0])
      triangles.push_back (triangle);
    for (const auto& [a, b] : {std::pair (i, k), std::pair (k, j)}) {
      parts_.emplace_back (a, b);
      if (b > a + 1)
        addEdge (piece[a], piece[b]);
    }
  }
}

} // namespace manifold
} // namespace pcl
