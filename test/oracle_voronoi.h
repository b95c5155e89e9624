#pragma once

#include "oracle_exact.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>
#include <vector>

/** \file
 * The Voronoi cell of a lattice point as an intersection of half-spaces, and its subpolytopes by definitions
 * 2.2 and 2.3 of Dey, Giesen, Goswami and Zhao. Nothing here knows of Delaunay cells. */

namespace oracle {

using Vector3l = Eigen::Matrix<long double, 3, 1>;
using Vector2l = Eigen::Matrix<long double, 2, 1>;

/** \brief The Voronoi cell of one sample, relative to it. */
struct VoronoiOracle
{
  struct Vertex
  {
    Vector3l position;
    std::vector<int> faces; ///< numbers of all half-spaces that touch it, ascending
  };

  struct Ray
  {
    Vector3l direction; ///< unit
    std::vector<int> faces;
  };

  std::vector<int> samples;      ///< half-space i is that of the bisector with this sample
  std::vector<Vector3l> normals; ///< and this is the vector to it
  std::vector<Vertex> vertices;
  std::vector<Ray> rays; ///< unbounded edges
};

/** \brief Enumerates the vertices by triples and the unbounded edges by pairs of half-spaces; exact. */
inline VoronoiOracle
voronoiCell (const Eigen::Matrix3Xd& points, int sample)
{
  VoronoiOracle cell;
  std::vector<Vector<Integer>> n;
  for (int q = 0; q < points.cols (); ++q)
    if (q != sample) {
      cell.samples.push_back (q);
      cell.normals.emplace_back ((points.col (q) - points.col (sample)).cast<long double> ());
      n.push_back (fromTo<Integer> (points.col (sample), points.col (q)));
    }
  const int count = static_cast<int> (n.size ());

  std::set<std::vector<int>> seen;
  for (int i = 0; i < count; ++i)
    for (int j = i + 1; j < count; ++j)
      for (int k = j + 1; k < count; ++k) {
        const Center<Integer> center = centerOf (n[i], n[j], n[k]);
        std::vector<int> touching;
        bool inside = center.denominator != 0;
        for (int l = 0; l < count && inside; ++l) {
          const int side = sideOfSphere (center, n[l]);
          inside = side <= 0;
          if (side == 0)
            touching.push_back (l);
        }
        if (inside && seen.insert (touching).second)
          cell.vertices.push_back ({rounded (center.numerator, Integer (2 * center.denominator)), touching});
      }

  seen.clear ();
  for (int i = 0; i < count; ++i)
    for (int j = i + 1; j < count; ++j)
      for (int turn = -1; turn <= 1; turn += 2) {
        Vector<Integer> d = cross (n[i], n[j]);
        if (isZero (d))
          continue;
        for (Integer& x : d)
          x *= turn;
        // The edge starts where both bisectors meet the plane orthogonal to it, and goes on if it stays in
        // every half-space.
        const Center<Integer> foot = centerOf (n[i], n[j]);
        std::vector<int> touching;
        bool edge = true;
        for (int l = 0; l < count && edge; ++l) {
          const int along = sign<Integer> (dot (n[l], d));
          edge = along <= 0 && (along < 0 || sideOfSphere (foot, n[l]) <= 0);
          if (along == 0 && sideOfSphere (foot, n[l]) == 0)
            touching.push_back (l);
        }
        if (!edge)
          continue;
        std::vector<int> key = touching;
        key.push_back (-1 - turn);
        if (seen.insert (key).second)
          cell.rays.push_back ({rounded (d, Integer (1)).normalized (), touching});
      }
  return cell;
}

/** \brief A pole, or that there is none that everyone would agree on. */
struct Pole
{
  long double height = 0;                 ///< infinite where the subpolytope is unbounded
  Vector3l direction = Vector3l::Zero (); ///< unit
  bool height_is_sure = true;
  bool direction_is_sure = false; ///< by a margin, up to the sign for V1
};

constexpr long double POLE_MARGIN = 1e-6L;

/** \brief The pole among vectors: the longest; sure if no other one is nearly as long. */
inline Pole
longest (const std::vector<Vector3l>& vectors)
{
  Pole pole;
  for (const Vector3l& v : vectors)
    if (v.norm () > pole.height) {
      pole.height = v.norm ();
      pole.direction = v.normalized ();
    }
  pole.direction_is_sure = pole.height > 0;
  for (const Vector3l& v : vectors)
    if (v.norm () > pole.height * (1 - POLE_MARGIN) &&
        (v.normalized () - pole.direction).norm () > POLE_MARGIN)
      pole.direction_is_sure = false;
  return pole;
}

/** \brief The average of the directions of unbounded edges; not sure where it nearly vanishes. */
inline Pole
averageDirection (const std::vector<Vector3l>& directions)
{
  Pole pole;
  pole.height = std::numeric_limits<long double>::infinity ();
  Vector3l sum = Vector3l::Zero ();
  for (const Vector3l& d : directions)
    sum += d;
  const long double length = sum.norm () / static_cast<long double> (directions.size ());
  pole.direction_is_sure = length > 0.2501L; // below a quarter the library takes the common axis
  pole.direction = length > 0 ? Vector3l (sum.normalized ()) : Vector3l::Zero ();
  return pole;
}

/** \brief The pole of the whole cell. Its direction is not sure where samples of the hull are cocircular: how
 * many unbounded edges stand for one depends on how a triangulation resolves them. */
inline Pole
poleOfV3 (const VoronoiOracle& cell)
{
  std::vector<Vector3l> candidates;
  if (!cell.rays.empty ()) {
    bool cocircular = false;
    for (const VoronoiOracle::Ray& ray : cell.rays) {
      candidates.push_back (ray.direction);
      cocircular = cocircular || ray.faces.size () > 2;
    }
    Pole pole = averageDirection (candidates);
    pole.direction_is_sure = pole.direction_is_sure && !cocircular;
    return pole;
  }
  for (const VoronoiOracle::Vertex& vertex : cell.vertices)
    candidates.push_back (vertex.position);
  return longest (candidates);
}

/** \brief A convex polygon cut by the half-plane n x <= c. */
inline std::vector<Vector2l>
cut (const std::vector<Vector2l>& polygon, const Vector2l& n, long double c)
{
  std::vector<Vector2l> result;
  for (std::size_t i = 0; i < polygon.size (); ++i) {
    const Vector2l& a = polygon[i];
    const Vector2l& b = polygon[(i + 1) % polygon.size ()];
    const long double sa = n.dot (a) - c;
    const long double sb = n.dot (b) - c;
    if (sa <= 0)
      result.push_back (a);
    if ((sa < 0 && sb > 0) || (sa > 0 && sb < 0))
      result.push_back (a + sa / (sa - sb) * (b - a));
  }
  return result;
}

/** \brief The pole of V2, the section of the cell by the plane through the sample orthogonal to a unit
 * normal. */
inline Pole
poleOfV2 (const VoronoiOracle& cell, const Vector3l& normal)
{
  const Vector3l e1 = normal.unitOrthogonal ();
  const Vector3l e2 = normal.cross (e1);
  const auto inSpace = [&] (const Vector2l& v) { return Vector3l (v.x () * e1 + v.y () * e2); };
  // A direction stays in the section if it stays in every half-plane: the normals of those leave a gap of at
  // least half a turn.
  std::vector<long double> angles;
  std::vector<Vector2l> normals;
  long double largest = 0;
  for (const Vector3l& n : cell.normals) {
    normals.emplace_back (n.dot (e1), n.dot (e2));
    largest = std::max (largest, n.norm ());
    if (normals.back ().norm () > 1e-12L * n.norm ())
      angles.push_back (std::atan2 (normals.back ().y (), normals.back ().x ()));
  }
  std::sort (angles.begin (), angles.end ());
  constexpr long double HALF_TURN = 3.14159265358979323846L;
  long double gap = angles.empty () ? 2 * HALF_TURN : angles.front () + 2 * HALF_TURN - angles.back ();
  std::pair<long double, long double> around (angles.empty () ? 0 : angles.back (),
                                              angles.empty () ? 0 : angles.front ());
  for (std::size_t i = 0; i + 1 < angles.size (); ++i)
    if (angles[i + 1] - angles[i] > gap) {
      gap = angles[i + 1] - angles[i];
      around = {angles[i], angles[i + 1]};
    }
  const auto unit = [] (long double angle) { return Vector2l (std::cos (angle), std::sin (angle)); };
  if (gap > HALF_TURN + 1e-9L)
    return averageDirection (
      {inSpace (unit (around.first + HALF_TURN / 2)), inSpace (unit (around.second - HALF_TURN / 2))});

  const long double box = 1e9L * (largest + 1);
  std::vector<Vector2l> polygon{{-box, -box}, {box, -box}, {box, box}, {-box, box}};
  for (std::size_t i = 0; i < normals.size (); ++i)
    polygon = cut (polygon, normals[i], cell.normals[i].squaredNorm () / 2);
  std::vector<Vector3l> corners;
  corners.reserve (polygon.size ());
  for (const Vector2l& corner : polygon)
    corners.push_back (inSpace (corner));
  Pole pole = longest (corners);
  // Nearly unbounded: doubles may see it otherwise.
  pole.height_is_sure = gap < HALF_TURN - 1e-9L && pole.height < 1e5L * largest;
  pole.direction_is_sure = pole.direction_is_sure && pole.height_is_sure;
  return pole;
}

/** \brief The pole of V1, the section of the cell by the line through the sample along a unit vector. */
inline Pole
poleOfV1 (const VoronoiOracle& cell, const Vector3l& direction)
{
  long double reach[2] = {std::numeric_limits<long double>::infinity (),
                          std::numeric_limits<long double>::infinity ()};
  Pole pole;
  for (const Vector3l& n : cell.normals) {
    const long double along = n.dot (direction);
    if (std::abs (along) < 1e-9L * n.norm ())
      pole.height_is_sure = false;
    else
      reach[along > 0] = std::min (reach[along > 0], n.squaredNorm () / (2 * std::abs (along)));
  }
  pole.height = std::max (reach[0], reach[1]);
  // A half-space that the line hardly meets cuts it far away only.
  for (const Vector3l& n : cell.normals)
    if (pole.height < 1e7L * n.norm ())
      pole.height_is_sure = true;
  pole.direction = reach[1] > reach[0] ? direction : Vector3l (-direction);
  pole.direction_is_sure = std::abs (reach[0] - reach[1]) > POLE_MARGIN * pole.height;
  return pole;
}

} // namespace oracle
