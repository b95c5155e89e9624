// Which Voronoi edges and faces a cocone meets, against points of those edges and faces.
#include "oracle_lattice.h"
#include "oracle_voronoi.h"

#include "voronoi/cocone.h"
#include "voronoi/subpolytopes.h"

#include <gtest/gtest.h>

#include <set>

namespace {

using namespace oracle;
using pcl::manifold::coconeMeetsEdge;
using pcl::manifold::coconeNeighbors;
using pcl::manifold::DelaunayComplex;
using pcl::manifold::VoronoiCell;

const double SINE = std::sin (M_PI / 8.0);
const double COSINE = std::cos (M_PI / 8.0);
constexpr double MARGIN = 0.01;

Eigen::Vector3d
randomDirection (Random& random)
{
  Eigen::Vector3d v;
  do
    v = Eigen::Vector3d (random.uniform (-1, 1), random.uniform (-1, 1), random.uniform (-1, 1));
  while (v.norm () > 1.0 || v.norm () < 0.1);
  return v.normalized ();
}

// A Voronoi vertex relative to p, or a direction, exactly and then rounded.
Eigen::Vector3d
exactVertex (const DelaunayComplex& complex, std::int32_t p, std::int32_t cell)
{
  const Eigen::Matrix3Xd& points = complex.samples->points;
  if (complex.isInfinite (cell))
    return complex.centers.col (cell);
  std::vector<Vector<Integer>> others;
  for (const std::int32_t vertex : complex.cells[static_cast<std::size_t> (cell)])
    if (vertex != p)
      others.push_back (fromTo<Integer> (points.col (p), points.col (vertex)));
  const Center<Integer> center = centerOf (others[0], others[1], others[2]);
  return rounded (center.numerator, Integer (2 * center.denominator)).cast<double> ();
}

// The line of the Voronoi edge dual to a triangle at p: its point nearest to p and its direction.
struct Line
{
  Eigen::Vector3d foot;
  Eigen::Vector3d direction;
};

Line
dualLine (const DelaunayComplex& complex, std::int32_t p, std::int32_t cell, int facet)
{
  const Eigen::Matrix3Xd& points = complex.samples->points;
  std::vector<Vector<Integer>> others;
  for (int k = 0; k < 4; ++k) {
    const std::int32_t vertex = complex.cells[static_cast<std::size_t> (cell)][static_cast<std::size_t> (k)];
    if (k != facet && vertex != p)
      others.push_back (fromTo<Integer> (points.col (p), points.col (vertex)));
  }
  const Center<Integer> foot = centerOf (others[0], others[1]);
  return {rounded (foot.numerator, Integer (2 * foot.denominator)).cast<double> (),
          rounded (cross (others[0], others[1]), Integer (1)).normalized ().cast<double> ()};
}

// The smallest sine of an angle between the plane with this normal and the points of an edge, seen from p: at
// steps of a small angle from one end to the other, which may be at infinity.
double
smallestSine (const Line& line, const Eigen::Vector3d& a, const Eigen::Vector3d& b, bool to_infinity,
              const Eigen::Vector3d& normal)
{
  const double distance = line.foot.norm ();
  const double begin = std::atan2 (a.dot (line.direction), distance);
  const double end = to_infinity ? std::copysign (M_PI / 2, b.dot (line.direction))
                                 : std::atan2 (b.dot (line.direction), distance);
  double smallest = 1.0;
  double before = 0.0;
  constexpr int STEPS = 1000;
  for (int step = 0; step <= STEPS; ++step) {
    const double angle = begin + (end - begin) * step / STEPS;
    const Eigen::Vector3d x = std::cos (angle) * line.foot / distance + std::sin (angle) * line.direction;
    const double sine = x.dot (normal);
    smallest = sine * before < 0.0 ? 0.0 : std::min (smallest, std::abs (sine));
    before = sine;
  }
  return smallest;
}

TEST (Cocone, MeetsTheEdgesThatHaveAPointInIt)
{
  int met = 0;
  int missed = 0;
  forEachLattice (20, 4, 40, [&] (const Eigen::Matrix3Xd& cloud, int kind) {
    const auto complex = complexOf (cloud);
    if (complex->affine_dimension != 3)
      return;
    Random random (static_cast<std::uint64_t> (cloud.cols ()));
    for (std::int32_t p = 0; p < cloud.cols (); ++p) {
      const VoronoiCell cell (*complex, p);
      const Eigen::Vector3d normal =
        random.coin () ? randomDirection (random) : computeSubpolytopes (*complex, cell).normal;
      cell.forEachEdge ([&] (std::int32_t a, std::int32_t b, int facet) {
        const double sine = smallestSine (dualLine (*complex, p, a, facet), exactVertex (*complex, p, a),
                                          exactVertex (*complex, p, b), cell.isInfinite (b), normal);
        if (std::abs (sine - SINE) < MARGIN)
          return;
        ++(sine < SINE ? met : missed);
        EXPECT_EQ (coconeMeetsEdge (cell, normal, a, b), sine < SINE)
          << "kind " << kind << ", sample " << p << ", cells " << a << " " << b << ", sine " << sine;
      });
    }
  });
  EXPECT_GT (met, 20000);
  EXPECT_GT (missed, 20000);
}

// In a plane every Voronoi edge is a line across it.
TEST (Cocone, MeetsEveryEdgeOfAPlane)
{
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const Eigen::Matrix3Xd cloud = latticeCloud (Lattice::PLANE, 20, seed);
    const auto complex = complexOf (cloud);
    if (complex->affine_dimension != 2)
      continue;
    for (std::int32_t p = 0; p < cloud.cols (); ++p) {
      const VoronoiCell cell (*complex, p);
      cell.forEachEdge ([&] (std::int32_t a, std::int32_t b, int) {
        EXPECT_TRUE (coconeMeetsEdge (cell, complex->centers.col (0), a, b));
      });
    }
  }
}

// The neighbour through whose face a ray from p leaves the cell; -1 where it does not.
std::int32_t
faceHit (const VoronoiOracle& cell, const Eigen::Vector3d& direction)
{
  double nearest = std::numeric_limits<double>::infinity ();
  std::int32_t through = -1;
  for (std::size_t face = 0; face < cell.samples.size (); ++face) {
    const Eigen::Vector3d n = cell.normals[face].cast<double> ();
    const double distance = n.squaredNorm () / (2.0 * n.dot (direction));
    if (n.dot (direction) > 0.0 && distance < nearest) {
      nearest = distance;
      through = cell.samples[face];
    }
  }
  return through;
}

// Those of random rays within the cone.
std::set<std::int32_t>
facesHit (const VoronoiOracle& cell, const Eigen::Vector3d& axis, int rays, Random& random)
{
  std::set<std::int32_t> hit;
  for (int i = 0; i < rays; ++i) {
    Eigen::Vector3d d = randomDirection (random);
    while (std::abs (d.dot (axis)) < COSINE + 1e-9)
      d = (d + random.uniform () * (d.dot (axis) < 0.0 ? -1.0 : 1.0) * axis).normalized ();
    hit.insert (faceHit (cell, d));
  }
  hit.erase (-1);
  return hit;
}

// The largest cosine of an angle between an axis and the points of the edges of a face, seen from p.
double
largestCosine (const VoronoiOracle& cell, int face, const Eigen::Vector3d& axis)
{
  const auto touches = [] (const auto& part, int with) {
    return std::find (part.faces.begin (), part.faces.end (), with) != part.faces.end ();
  };
  double largest = 0.0;
  const auto look = [&] (const Vector3l& x) {
    largest =
      std::max (largest, static_cast<double> (std::abs (x.dot (axis.cast<long double> ()) / x.norm ())));
  };
  for (int other = 0; other < static_cast<int> (cell.samples.size ()); ++other) {
    std::vector<Vector3l> ends;
    for (const VoronoiOracle::Vertex& vertex : cell.vertices)
      if (touches (vertex, face) && touches (vertex, other))
        ends.push_back (vertex.position);
    for (const Vector3l& end : ends)
      look (end);
    for (const VoronoiOracle::Ray& ray : cell.rays)
      if (touches (ray, face) && touches (ray, other)) {
        look (ray.direction);
        if (!ends.empty ())
          ends.push_back (ends[0] + 1e6L * ends[0].norm () * ray.direction);
      }
    if (ends.size () < 2 || other == face)
      continue;
    const Vector3l u = (ends[1] - ends[0]).normalized ();
    const Vector3l foot = ends[0] - ends[0].dot (u) * u;
    const long double begin = std::atan2 (ends[0].dot (u), foot.norm ());
    const long double end = std::atan2 (ends[1].dot (u), foot.norm ());
    for (int step = 0; step <= 100; ++step) {
      const long double angle = begin + (end - begin) * step / 100;
      look (std::cos (angle) * foot.normalized () + std::sin (angle) * u);
    }
  }
  return largest;
}

TEST (Cocone, MeetsTheFacesThatHaveAPointInIt)
{
  std::size_t hits = 0;
  std::size_t results = 0;
  forEachLattice (15, 4, 24, [&] (const Eigen::Matrix3Xd& cloud, int kind) {
    const auto complex = complexOf (cloud);
    if (complex->affine_dimension != 3)
      return;
    Random random (static_cast<std::uint64_t> (cloud.cols ()));
    for (std::int32_t p = 0; p < cloud.cols (); ++p) {
      const VoronoiCell cell (*complex, p);
      const VoronoiOracle expected = voronoiCell (cloud, p);
      const Eigen::Vector3d axis =
        random.coin () ? randomDirection (random) : computeSubpolytopes (*complex, cell).tangent;
      const std::vector<std::int32_t> result = coconeNeighbors (*complex, cell, axis);
      ASSERT_TRUE (std::is_sorted (result.begin (), result.end ()));
      ASSERT_EQ (std::adjacent_find (result.begin (), result.end ()), result.end ());
      const std::set<std::int32_t> hit = facesHit (expected, axis, 300, random);
      hits += hit.size ();
      results += result.size ();
      for (const std::int32_t q : hit)
        ASSERT_TRUE (std::binary_search (result.begin (), result.end (), q))
          << "kind " << kind << ", sample " << p << ", neighbour " << q;
      for (const std::int32_t q : result)
        ASSERT_TRUE (hit.count (q) != 0 || q == faceHit (expected, axis) || q == faceHit (expected, -axis) ||
                     largestCosine (expected, q < p ? q : q - 1, axis) > COSINE - 0.002)
          << "kind " << kind << ", sample " << p << ", neighbour " << q;
    }
  });
  EXPECT_GT (hits, 6000u);
  EXPECT_GT (hits, results / 10 * 9);
}

// In a plane faces are strips across it: the cone meets those that it meets in the plane.
TEST (Cocone, MeetsTheFacesOfAPlane)
{
  int met = 0;
  int unseen = 0;
  for (const Lattice kind : {Lattice::PLANE, Lattice::FLAT_GRID})
    for (std::uint64_t seed = 0; seed < 150; ++seed) {
      const Eigen::Matrix3Xd cloud = latticeCloud (kind, 20, seed);
      const auto complex = complexOf (cloud);
      if (complex->affine_dimension != 2)
        continue;
      Random random (seed);
      for (std::int32_t p = 0; p < cloud.cols (); ++p) {
        const VoronoiCell cell (*complex, p);
        const Eigen::Vector3d normal = complex->centers.col (0);
        Eigen::Vector3d axis = randomDirection (random).cross (normal).normalized ();
        if (random.coin ())
          axis = computeSubpolytopes (*complex, cell).tangent;
        const Eigen::Vector3d side = normal.cross (axis);
        // Steps of a third of a degree; a face within two of them of the border of the cone may go either
        // way.
        const double step = M_PI / 8.0 / 64.0;
        std::set<std::int32_t> certain;
        std::set<std::int32_t> possible;
        const VoronoiOracle expected = voronoiCell (cloud, p);
        for (const double sign : {-1.0, 1.0})
          for (int i = -66; i <= 66; ++i) {
            const double angle = (i + 0.123456) * step;
            const std::int32_t q =
              faceHit (expected, sign * std::cos (angle) * axis + std::sin (angle) * side);
            possible.insert (q);
            if (std::abs (i) < 63)
              certain.insert (q);
          }
        certain.erase (-1);
        const std::vector<std::int32_t> result = coconeNeighbors (*complex, cell, axis);
        met += static_cast<int> (certain.size ());
        ASSERT_TRUE (std::includes (result.begin (), result.end (), certain.begin (), certain.end ()))
          << "seed " << seed << ", sample " << p << ", axis " << axis.transpose () << "\n"
          << cloud;
        // Where samples are cocircular, there are edges dual to a mere line across the plane.
        if (kind == Lattice::PLANE)
          for (const std::int32_t q : result)
            unseen += possible.count (q) == 0 ? 1 : 0;
      }
    }
  EXPECT_GT (met, 5000);
  EXPECT_LT (unseen, met / 50);
}

} // namespace
