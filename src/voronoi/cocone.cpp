#include "voronoi/cocone.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pcl {
namespace manifold {

const double COCONE_SINE = std::sin (M_PI / 8.0);
const double COCONE_COSINE = std::cos (M_PI / 8.0);

namespace {

/** The largest squared cosine of the angle between the line of u and a point a + t * direction, t in [0,
 * end]. */
double
largestSquaredCosine (const Eigen::Vector3d& u, const Eigen::Vector3d& a, const Eigen::Vector3d& direction,
                      double end)
{
  const auto squaredCosine = [&u] (const Eigen::Vector3d& x) {
    const double squared_norm = x.squaredNorm ();
    return squared_norm > 0.0 ? x.dot (u) * x.dot (u) / squared_norm : 1.0;
  };
  double largest = squaredCosine (a);
  largest =
    std::max (largest, squaredCosine (std::isinf (end) ? direction : Eigen::Vector3d (a + end * direction)));
  // The derivative vanishes at one point, the numerator being linear in t.
  const double a_u = a.dot (u);
  const double d_u = direction.dot (u);
  const double a_d = a.dot (direction);
  const double t = (d_u * a.squaredNorm () - a_u * a_d) / (a_u * direction.squaredNorm () - d_u * a_d);
  if (t > 0.0 && t < end && std::isfinite (t))
    largest = std::max (largest, squaredCosine (a + t * direction));
  return largest;
}

// The neighbours whose half-spaces cut the line of u, at its two ends.
std::array<std::int32_t, 2>
piercedNeighbors (const VoronoiCell& cell, const Eigen::Vector3d& u)
{
  std::array<std::int32_t, 2> pierced{-1, -1};
  std::array<double, 2> reach{std::numeric_limits<double>::infinity (),
                              std::numeric_limits<double>::infinity ()};
  cell.visitNeighbors ([&] (std::int32_t q) {
    const Eigen::Vector3d to_neighbor = cell.relative (q);
    const double along = to_neighbor.dot (u);
    const int end = along > 0.0 ? 0 : 1;
    const double distance = to_neighbor.squaredNorm () / (2.0 * std::abs (along));
    if (along != 0.0 && (distance < reach[end] || (distance == reach[end] && q < pierced[end]))) {
      reach[end] = distance;
      pierced[end] = q;
    }
  });
  return pierced;
}

} // namespace

bool
coconeMeetsEdge (const VoronoiCell& cell, const Eigen::Vector3d& normal, std::int32_t a, std::int32_t b)
{
  const Eigen::Vector3d va = cell.vertex (a);
  const Eigen::Vector3d vb = cell.vertex (b);
  const double sa = va.dot (normal);
  const double sb = vb.dot (normal);
  // What the cocone leaves of space are two convex cones: an edge misses it if both ends are in the same one.
  // An edge to infinity ends in its direction.
  if (std::abs (sa) < COCONE_SINE * va.norm () || std::abs (sb) < COCONE_SINE * vb.norm ())
    return true;
  return (sa < 0.0) != (sb < 0.0);
}

std::vector<std::int32_t>
coconeNeighbors (const DelaunayComplex& complex, const VoronoiCell& cell, const Eigen::Vector3d& tangent)
{
  constexpr double TO_INFINITY = std::numeric_limits<double>::infinity ();
  const double bound = COCONE_COSINE * COCONE_COSINE;
  std::vector<std::int32_t> neighbors;
  // A convex face meets a cone in its interior, where the axis pierces it, or along one of its edges.
  for (const std::int32_t q : piercedNeighbors (cell, tangent))
    if (q >= 0)
      neighbors.push_back (q);
  cell.forEachEdge ([&] (std::int32_t a, std::int32_t b, int facet) {
    const bool is_line = cell.isInfinite (a); // of samples in a plane, across it
    const bool to_infinity = cell.isInfinite (b);
    const Eigen::Vector3d va = is_line ? cell.triangleCenter (a, facet) : cell.vertex (a);
    const Eigen::Vector3d vb = cell.vertex (b);
    double cosine = largestSquaredCosine (tangent, va, to_infinity ? vb : Eigen::Vector3d (vb - va),
                                          to_infinity ? TO_INFINITY : 1.0);
    if (is_line)
      cosine = std::max (cosine, largestSquaredCosine (tangent, va, -vb, TO_INFINITY));
    if (cosine <= bound)
      return;
    for (int k = 0; k < 4; ++k)
      if (k != facet && complex.cells[a][k] != cell.sample ())
        neighbors.push_back (complex.cells[a][k]);
  });
  cell.forEachUnboundedFace ([&] (std::int32_t a, std::int32_t b, std::int32_t q, std::int32_t) {
    const Eigen::Vector3d da = cell.vertex (a);
    double cosine = largestSquaredCosine (tangent, da, cell.vertex (b) - da, 1.0);
    if (complex.affine_dimension == 2 && da.dot (cell.vertex (b)) < 0.0) {
      // At the rim of a plane the face is half of the bisector: all directions across and out of the plane.
      const Eigen::Vector3d out = cell.relative (q).cross (da).normalized ();
      cosine = tangent.dot (da) * tangent.dot (da) + tangent.dot (out) * tangent.dot (out);
    }
    if (cosine > bound)
      neighbors.push_back (q);
  });
  std::sort (neighbors.begin (), neighbors.end ());
  neighbors.erase (std::unique (neighbors.begin (), neighbors.end ()), neighbors.end ());
  return neighbors;
}

} // namespace manifold
} // namespace pcl
