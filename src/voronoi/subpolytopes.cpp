#include "voronoi/subpolytopes.h"

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

// Where the Voronoi edge from the vertex a, which is on the positive side of the plane through p orthogonal
// to the normal, to the vertex b, which is not, crosses the plane; p if it does not in any finite place. The
// height of both is given.
Eigen::Vector3d
crossing (const DelaunayComplex& complex, const VoronoiCell& cell, const Eigen::Vector3d& normal,
          std::int32_t a, double height_a, std::int32_t b, double height_b, int facet)
{
  const Eigen::Vector3d va = cell.vertex (a);
  const Eigen::Vector3d vb = cell.vertex (b);
  if (!cell.isInfinite (a) && !cell.isInfinite (b))
    return va + height_a / (height_a - height_b) * (vb - va);
  if (!cell.isInfinite (a))
    return height_b < 0.0 ? Eigen::Vector3d (va - height_a / height_b * vb)
                          : Eigen::Vector3d (Eigen::Vector3d::Zero ());
  if (!cell.isInfinite (b))
    return vb - height_b / height_a * va;
  if (complex.cells[a][facet] != DelaunayComplex::INFINITE_VERTEX)
    return Eigen::Vector3d::Zero (); // an edge at infinity
  // Samples in a plane: the edge is the line through the centre of their triangle.
  const Eigen::Vector3d center = cell.triangleCenter (a, facet);
  return center - center.dot (normal) / height_a * va;
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
  for (const std::int32_t a : cell) {
    const double height_a = cell.vertex (a).dot (normal);
    if (!(height_a > 0.0))
      continue;
    for (int facet = 0; facet < 4; ++facet) {
      if (complex.cells[a][facet] == cell.sample ())
        continue;
      const std::int32_t b = complex.neighbors[a][facet];
      const double height_b = cell.vertex (b).dot (normal);
      if (height_b > 0.0)
        continue;
      const Eigen::Vector3d place = crossing (complex, cell, normal, a, height_a, b, height_b, facet);
      if (place.squaredNorm () > farthest.squaredNorm ())
        farthest = place;
    }
  }
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
  cell.visitNeighbors ([&] (std::int32_t q) {
    const Eigen::Vector3d to_neighbor = cell.relative (q);
    const double along = to_neighbor.dot (result.tangent);
    // The bisector of p and q cuts the line at |q|^2 / (2 along): divided only where that is nearer.
    const double squared = to_neighbor.squaredNorm ();
    if (along > 0.0) {
      if (squared < 2.0 * along * ahead)
        ahead = squared / (2.0 * along);
    } else if (along < 0.0 && squared < -2.0 * along * behind) {
      behind = squared / (-2.0 * along);
    }
  });
  if (behind > ahead)
    result.tangent = -result.tangent;
  result.heights[0] = std::max (ahead, behind);
}

} // namespace

Pole
computePole (const VoronoiCell& cell)
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
  if (unbounded.empty ())
    return {normalizedOr (farthest, Eigen::Vector3d::UnitX ()), farthest.norm ()};
  return {unbounded.direction (), INFINITE_HEIGHT};
}

Subpolytopes
computeSubpolytopes (const DelaunayComplex& complex, const VoronoiCell& cell)
{
  Subpolytopes result;
  const Pole pole = computePole (cell);
  result.normal = pole.direction;
  result.heights[2] = pole.height;
  computeBinormal (complex, cell, result);
  computeTangent (cell, result);
  return result;
}

} // namespace manifold
} // namespace pcl
