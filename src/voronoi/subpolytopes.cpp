#include "voronoi/subpolytopes.h"

#include "delaunay/circumcenter.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl {
namespace manifold {

namespace {

constexpr double INFINITE_HEIGHT = std::numeric_limits<double>::infinity ();

/** The average direction of unbounded edges. For a cell that is unbounded in opposite directions, as those of
 * a thin sheet of samples are, the average vanishes, or what is left of it is an accident: then the axis that
 * the directions have in common takes its place. */
class DirectionAverage
{
public:
  void add (const Eigen::Vector3d& unit)
  {
    sum_ += unit;
    outer_.noalias () += unit * unit.transpose ();
    ++count_;
  }

  bool empty () const { return count_ == 0; }

  Eigen::Vector3d direction () const
  {
    constexpr double VANISHING = 0.25; // the average of unit vectors that mostly cancel each other
    if (sum_.norm () > VANISHING * count_)
      return sum_.normalized ();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver (outer_);
    const Eigen::Vector3d axis = solver.eigenvectors ().col (2);
    return axis.dot (sum_) < 0.0 ? Eigen::Vector3d (-axis) : axis;
  }

private:
  Eigen::Vector3d sum_ = Eigen::Vector3d::Zero ();
  Eigen::Matrix3d outer_ = Eigen::Matrix3d::Zero ();
  int count_ = 0;
};

// A unit vector; which one is chosen for a zero vector does not matter, but it must be one.
Eigen::Vector3d
normalizedOr (const Eigen::Vector3d& vector, const Eigen::Vector3d& fallback)
{
  const double norm = vector.norm ();
  return norm > 0.0 && std::isfinite (norm) ? Eigen::Vector3d (vector / norm) : fallback;
}

// The pole of V3, the whole Voronoi cell.
void
computeNormal (const VoronoiCell& cell, Subpolytopes& result)
{
  DirectionAverage unbounded;
  Eigen::Vector3d farthest = Eigen::Vector3d::Zero ();
  for (const std::int32_t vertex : cell) {
    const Eigen::Vector3d v = cell.vertex (vertex);
    if (cell.isInfinite (vertex))
      unbounded.add (v);
    else if (v.squaredNorm () > farthest.squaredNorm ())
      farthest = v;
  }
  result.normal =
    unbounded.empty () ? normalizedOr (farthest, Eigen::Vector3d::UnitX ()) : unbounded.direction ();
  result.heights[2] = unbounded.empty () ? farthest.norm () : INFINITE_HEIGHT;
}

// Where the plane through p orthogonal to the normal meets the Voronoi edge between the cells a and b, if it
// does.
bool
crossEdge (const DelaunayComplex& complex, const VoronoiCell& cell, const Eigen::Vector3d& normal,
           std::int32_t a, std::int32_t b, int facet, Eigen::Vector3d& crossing)
{
  const Eigen::Vector3d vb = cell.vertex (b);
  const double sb = vb.dot (normal);
  if (cell.isInfinite (a)) { // samples in a plane: the edge is a line through the centre of the triangle
    if (sb == 0.0)
      return false;
    const DelaunayComplex::Cell& vertices = complex.cells[a];
    std::array<std::int32_t, 3> triangle{};
    for (int k = 0, count = 0; k < 4; ++k)
      if (k != facet)
        triangle[count++] = vertices[k];
    const Eigen::Vector3d center =
      circumcenter (cell.relative (triangle[0]), cell.relative (triangle[1]), cell.relative (triangle[2]));
    crossing = center - center.dot (normal) / sb * vb;
    return true;
  }
  const Eigen::Vector3d va = cell.vertex (a);
  const double sa = va.dot (normal);
  if (!((sa <= 0.0 && sb >= 0.0) || (sa >= 0.0 && sb <= 0.0)) || sa == sb)
    return false;
  crossing = cell.isInfinite (b) ? Eigen::Vector3d (va - sa / sb * vb)
                                 : Eigen::Vector3d (va + sa / (sa - sb) * (vb - va));
  return sb != 0.0 || !cell.isInfinite (b);
}

// The pole of V2, the section of the cell by the plane through p orthogonal to the normal.
void
computeBinormal (const DelaunayComplex& complex, const VoronoiCell& cell, Subpolytopes& result)
{
  const Eigen::Vector3d& normal = result.normal;
  DirectionAverage unbounded;
  if (std::isinf (result.heights[2]))
    cell.forEachUnboundedFace ([&] (std::int32_t a, std::int32_t b, std::int32_t q, std::int32_t r) {
      const Eigen::Vector3d da = cell.vertex (a);
      const Eigen::Vector3d db = cell.vertex (b);
      const double sa = da.dot (normal);
      const double sb = db.dot (normal);
      if (sa * sb > 0.0)
        return;
      // The face is the part of the bisector plane of p and q between the directions da and db.
      const Eigen::Vector3d w = normalizedOr (normal.cross (cell.relative (q)), Eigen::Vector3d::Zero ());
      const double side = w.dot (std::abs (sb) * da + std::abs (sa) * db);
      // Opposite directions, as in a plane: the face is the half of the bisector away from the facet.
      const double sign = std::abs (side) > 1e-12 ? side : -w.dot (cell.relative (r));
      if (w.squaredNorm () > 0.0)
        unbounded.add (sign < 0.0 ? Eigen::Vector3d (-w) : w);
    });
  if (!unbounded.empty ()) {
    const Eigen::Vector3d direction = unbounded.direction ();
    result.binormal = normalizedOr (direction - direction.dot (normal) * normal, normal.unitOrthogonal ());
    result.heights[1] = INFINITE_HEIGHT;
    return;
  }
  Eigen::Vector3d farthest = Eigen::Vector3d::Zero ();
  cell.forEachEdge ([&] (std::int32_t a, std::int32_t b, int facet) {
    Eigen::Vector3d crossing;
    if (crossEdge (complex, cell, normal, a, b, facet, crossing) &&
        crossing.squaredNorm () > farthest.squaredNorm ())
      farthest = crossing;
  });
  result.heights[1] = farthest.norm ();
  // Far crossings carry rounding errors along the normal.
  result.binormal = normalizedOr (farthest - farthest.dot (normal) * normal, normal.unitOrthogonal ());
}

// V1 is a segment: half-spaces of the Delaunay neighbours cut the line through p at both ends.
void
computeTangent (const VoronoiCell& cell, Subpolytopes& result)
{
  result.tangent = result.normal.cross (result.binormal).normalized ();
  double ahead = INFINITE_HEIGHT;
  double behind = INFINITE_HEIGHT;
  cell.forEachNeighbor ([&] (std::int32_t q) {
    const Eigen::Vector3d to_neighbor = cell.relative (q);
    const double along = to_neighbor.dot (result.tangent);
    const double reach = to_neighbor.squaredNorm () / (2.0 * std::abs (along));
    if (along > 0.0)
      ahead = std::min (ahead, reach);
    else if (along < 0.0)
      behind = std::min (behind, reach);
  });
  if (behind > ahead)
    result.tangent = -result.tangent;
  result.heights[0] = std::max (ahead, behind);
}

} // namespace

Subpolytopes
computeSubpolytopes (const DelaunayComplex& complex, const VoronoiCell& cell)
{
  Subpolytopes result;
  computeNormal (cell, result);
  computeBinormal (complex, cell, result);
  computeTangent (cell, result);
  return result;
}

} // namespace manifold
} // namespace pcl
