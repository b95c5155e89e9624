#pragma once

#include "oracle_exact.h"

#include <pcl/manifold/delaunay_complex.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

/** \file
 * What the headers promise of a DelaunayComplex, checked from the definitions. Every check gives a
 * description of the first place where the promise is broken, or an empty string. */

namespace oracle {

using pcl::manifold::DelaunayComplex;

constexpr std::int32_t INFINITE = DelaunayComplex::INFINITE_VERTEX;

inline std::string
broken (const std::string& what, std::size_t where)
{
  std::ostringstream text;
  text << what << " at " << where;
  return text.str ();
}

/** \brief The samples of a cell other than the vertex opposite of a facet, ascending. */
inline std::array<std::int32_t, 3>
sortedFacet (const DelaunayComplex::Cell& cell, int facet)
{
  std::array<std::int32_t, 3> result{};
  for (int k = 0, count = 0; k < 4; ++k)
    if (k != facet)
      result[count++] = cell[k];
  std::sort (result.begin (), result.end ());
  return result;
}

inline int
infinitePosition (const DelaunayComplex::Cell& cell)
{
  return static_cast<int> (std::find (cell.begin (), cell.end (), INFINITE) - cell.begin ());
}

/** \brief Sizes of the arrays, valid and distinct vertices, finite cells first, rows of incident cells. */
inline std::string
brokenArrays (const DelaunayComplex& complex)
{
  const std::size_t n = complex.cells.size ();
  const auto samples = static_cast<std::size_t> (complex.samples->size ());
  if (complex.neighbors.size () != n || complex.centers.cols () != static_cast<Eigen::Index> (n))
    return "sizes of the arrays";
  std::vector<std::vector<std::int32_t>> rows (samples);
  for (std::size_t i = 0; i < n; ++i) {
    DelaunayComplex::Cell sorted = complex.cells[i];
    std::sort (sorted.begin (), sorted.end ());
    if (sorted[0] < INFINITE || sorted[3] >= static_cast<std::int32_t> (samples) ||
        std::adjacent_find (sorted.begin (), sorted.end ()) != sorted.end ())
      return broken ("vertices", i);
    if ((sorted[0] == INFINITE) != (static_cast<std::int32_t> (i) >= complex.finite_cells))
      return broken ("finite cells first", i);
    if (!complex.centers.col (static_cast<Eigen::Index> (i)).allFinite ())
      return broken ("finite centre", i);
    for (const std::int32_t vertex : complex.cells[i])
      if (vertex != INFINITE)
        rows[static_cast<std::size_t> (vertex)].push_back (static_cast<std::int32_t> (i));
  }
  if (complex.affine_dimension < 2 && n != 0)
    return "cells below affine dimension 2";
  if (complex.incident_offsets.size () != samples + 1 || complex.incident_offsets[0] != 0)
    return "offsets of incident cells";
  std::vector<std::int32_t> flat;
  for (std::size_t v = 0; v < samples; ++v) {
    flat.insert (flat.end (), rows[v].begin (), rows[v].end ());
    if (complex.incident_offsets[v + 1] != static_cast<std::int64_t> (flat.size ()))
      return broken ("row of incident cells", v);
  }
  return flat == complex.incident_cells ? "" : "incident cells";
}

/** \brief Neighbours are mutual and share the facet that they should; no facet has more than two cells. */
inline std::string
brokenNeighbors (const DelaunayComplex& complex)
{
  std::map<std::array<std::int32_t, 3>, int> cells_at;
  for (std::size_t i = 0; i < complex.cells.size (); ++i)
    for (int k = 0; k < 4; ++k) {
      const std::array<std::int32_t, 3> facet = sortedFacet (complex.cells[i], k);
      ++cells_at[facet];
      const std::int32_t neighbor = complex.neighbors[i][k];
      if (neighbor < 0 || neighbor >= static_cast<std::int32_t> (complex.cells.size ()) ||
          neighbor == static_cast<std::int32_t> (i))
        return broken ("neighbour", i);
      bool mutual = false;
      for (int m = 0; m < 4; ++m)
        mutual = mutual || (complex.neighbors[neighbor][m] == static_cast<std::int32_t> (i) &&
                            sortedFacet (complex.cells[neighbor], m) == facet);
      if (!mutual)
        return broken ("mutual neighbour", i);
    }
  // In a plane an inner edge with the infinite vertex is a facet on both sides of the plane.
  for (const auto& entry : cells_at)
    if (entry.second != 2 &&
        !(complex.affine_dimension == 2 && entry.first[0] == INFINITE && entry.second == 4))
      return "two cells at every facet";
  return "";
}

/** \brief Orientation of finite cells, and of hull facets with their directions; exact. */
template <typename Number>
std::string
brokenOrientation (const DelaunayComplex& complex)
{
  const Eigen::Matrix3Xd& p = complex.samples->points;
  for (std::size_t i = 0; i < complex.cells.size (); ++i) {
    const DelaunayComplex::Cell& cell = complex.cells[i];
    if (static_cast<std::int32_t> (i) < complex.finite_cells) {
      if (orientation<Number> (p.col (cell[0]), p.col (cell[1]), p.col (cell[2]), p.col (cell[3])) <= 0)
        return broken ("positive orientation", i);
      continue;
    }
    const Eigen::Vector3d direction = complex.centers.col (static_cast<Eigen::Index> (i));
    if (std::abs (direction.norm () - 1.0) > 1e-12)
      return broken ("unit direction", i);
    const std::array<std::int32_t, 3> f = sortedFacet (cell, infinitePosition (cell));
    const Vector<Number> n =
      cross (fromTo<Number> (p.col (f[0]), p.col (f[1])), fromTo<Number> (p.col (f[0]), p.col (f[2])));
    if (isZero (n))
      return broken ("hull facet of three points in general position", i);
    // The exact normal, rounded, along the direction.
    Number largest = 0;
    for (const Number& x : n)
      largest = std::max<Number> (largest, x < 0 ? Number (-x) : x);
    Eigen::Vector3d normal = rounded (n, largest).template cast<double> ().normalized ();
    const int side = normal.dot (direction) < 0.0 ? -1 : 1;
    if ((side * normal - direction).norm () > 1e-6)
      return broken ("direction orthogonal to the hull facet", i);
    for (Eigen::Index s = 0; s < p.cols (); ++s)
      if (side * sign<Number> (dot (n, fromTo<Number> (p.col (f[0]), p.col (s)))) > 0)
        return broken ("hull facet with all samples behind it", i);
  }
  return "";
}

/** \brief No sample is inside of the circumsphere of a finite cell; exact. */
template <typename Number>
std::string
brokenEmptySpheres (const DelaunayComplex& complex)
{
  const Eigen::Matrix3Xd& p = complex.samples->points;
  for (std::int32_t i = 0; i < complex.finite_cells; ++i) {
    const DelaunayComplex::Cell& cell = complex.cells[static_cast<std::size_t> (i)];
    const auto relative = [&] (Eigen::Index s) { return fromTo<Number> (p.col (cell[0]), p.col (s)); };
    const Center<Number> center = centerOf (relative (cell[1]), relative (cell[2]), relative (cell[3]));
    for (Eigen::Index s = 0; s < p.cols (); ++s)
      if (sideOfSphere (center, relative (s)) > 0)
        return broken ("empty circumsphere", static_cast<std::size_t> (i));
    const Eigen::Vector3d expected =
      p.col (cell[0]) + rounded (center.numerator, Number (2 * center.denominator)).template cast<double> ();
    const double distance = (expected - p.col (cell[0])).norm ();
    if (!((complex.centers.col (i) - expected).norm () <= 1e-7 * distance))
      return broken ("circumcentre", static_cast<std::size_t> (i));
  }
  return "";
}

/** \brief Affine dimension 3: every sample is used, and the cells with the infinite ones are a 3-sphere, the
 * finite ones a ball, the hull a 2-sphere; the volumes of the cells add up to that of the hull. */
template <typename Number>
std::string
brokenCounts (const DelaunayComplex& complex)
{
  std::set<std::int32_t> vertices[2];
  std::set<std::array<std::int32_t, 2>> edges[2];
  std::set<std::array<std::int32_t, 3>> facets[2];
  Number volume = 0;
  Number hull_volume = 0;
  const Eigen::Matrix3Xd& p = complex.samples->points;
  const Eigen::Vector3d base = p.col (0);
  for (std::size_t i = 0; i < complex.cells.size (); ++i) {
    const DelaunayComplex::Cell& cell = complex.cells[i];
    const bool finite = static_cast<std::int32_t> (i) < complex.finite_cells;
    for (int k = 0; k < 4; ++k) {
      const std::array<std::int32_t, 3> f = sortedFacet (cell, k);
      if (f[0] == INFINITE)
        continue;
      facets[0].insert (f);
      if (!finite)
        facets[1].insert (f);
      for (int m = 0; m < 3; ++m) {
        const std::array<std::int32_t, 2> e{f[m == 0 ? 1 : 0], f[m == 2 ? 1 : 2]};
        edges[0].insert (e);
        vertices[0].insert (f[m]);
        if (!finite) {
          edges[1].insert (e);
          vertices[1].insert (f[m]);
        }
      }
    }
    const auto relative = [&] (int k) {
      return fromTo<Number> (base, p.col (cell[static_cast<std::size_t> (k)]));
    };
    if (finite) {
      const auto from0 = [&] (int k) {
        return fromTo<Number> (p.col (cell[0]), p.col (cell[static_cast<std::size_t> (k)]));
      };
      volume += dot (from0 (1), cross (from0 (2), from0 (3)));
    } else {
      const int infinite = infinitePosition (cell);
      int f[3];
      for (int k = 0, count = 0; k < 4; ++k)
        if (k != infinite)
          f[count++] = k;
      const Number share = dot (relative (f[0]), cross (relative (f[1]), relative (f[2])));
      hull_volume += share < 0 ? Number (-share) : share; // the base is a sample, behind every facet
    }
  }
  const auto count = [] (const auto& set) { return static_cast<long> (set.size ()); };
  if (count (vertices[0]) != complex.samples->size ())
    return "every sample in a cell";
  if (count (vertices[0]) - count (edges[0]) + count (facets[0]) - complex.finite_cells != 1)
    return "Euler characteristic of the cells";
  if (count (vertices[1]) - count (edges[1]) + count (facets[1]) != 2)
    return "Euler characteristic of the hull";
  return volume == hull_volume ? "" : "volume of the hull";
}

/** \brief Affine dimension 2: two infinite cells at every triangle, opposite of each other; the empty circle;
 * a hull edge leads from one side of the plane to the other; a disk of triangles. */
template <typename Number>
std::string
brokenPlane (const DelaunayComplex& complex)
{
  const Eigen::Matrix3Xd& p = complex.samples->points;
  if (complex.finite_cells != 0)
    return "no finite cells in a plane";
  std::set<std::int32_t> vertices;
  std::set<std::array<std::int32_t, 2>> edges;
  for (std::size_t i = 0; i < complex.cells.size (); ++i) {
    const DelaunayComplex::Cell& cell = complex.cells[i];
    const int infinite = infinitePosition (cell);
    const std::int32_t other = complex.neighbors[i][static_cast<std::size_t> (infinite)];
    if (sortedFacet (cell, infinite) !=
        sortedFacet (complex.cells[other], infinitePosition (complex.cells[other])))
      return broken ("the other side of a triangle", i);
    const Eigen::Vector3d direction = complex.centers.col (static_cast<Eigen::Index> (i));
    if ((direction + complex.centers.col (other)).norm () > 1e-12)
      return broken ("opposite directions of a triangle's two sides", i);
    const std::array<std::int32_t, 3> f = sortedFacet (cell, infinite);
    vertices.insert (f.begin (), f.end ());
    const auto relative = [&] (Eigen::Index s) { return fromTo<Number> (p.col (f[0]), p.col (s)); };
    const Center<Number> center = centerOf (relative (f[1]), relative (f[2]));
    for (Eigen::Index s = 0; s < p.cols (); ++s)
      if (sideOfSphere (center, relative (s)) > 0)
        return broken ("empty circle", i);
    for (int k = 0; k < 4; ++k) {
      if (k == infinite)
        continue;
      std::array<std::int32_t, 2> e{};
      for (int m = 0, count = 0; m < 4; ++m)
        if (m != k && m != infinite)
          e[static_cast<std::size_t> (count++)] = cell[static_cast<std::size_t> (m)];
      std::sort (e.begin (), e.end ());
      edges.insert (e);
      const std::int32_t across = complex.neighbors[i][static_cast<std::size_t> (k)];
      if (across != other && direction.dot (complex.centers.col (across)) < 0.0)
        return broken ("neighbours on one side of the plane", i);
      if (across == other) {
        bool left = false;
        bool right = false;
        const Vector<Number> along = fromTo<Number> (p.col (e[0]), p.col (e[1]));
        const Vector<Number> inward = cross (
          along, cross (along, fromTo<Number> (p.col (e[0]), p.col (cell[static_cast<std::size_t> (k)]))));
        for (Eigen::Index s = 0; s < p.cols (); ++s) {
          const int side = sign<Number> (dot (inward, fromTo<Number> (p.col (e[0]), p.col (s))));
          left = left || side < 0;
          right = right || side > 0;
        }
        if (left && right)
          return broken ("edge of the hull", i);
      }
    }
  }
  const auto triangles = static_cast<long> (complex.cells.size ()) / 2;
  if (static_cast<std::int32_t> (vertices.size ()) != complex.samples->size ())
    return "every sample in a triangle";
  return static_cast<long> (vertices.size ()) - static_cast<long> (edges.size ()) + triangles == 1
           ? ""
           : "Euler characteristic of the triangles";
}

/** \brief Affine dimension 0 and 1: every sample once, in order along the line. */
template <typename Number>
std::string
brokenLine (const DelaunayComplex& complex)
{
  const Eigen::Matrix3Xd& p = complex.samples->points;
  std::vector<std::int32_t> sorted = complex.line;
  std::sort (sorted.begin (), sorted.end ());
  for (std::size_t i = 0; i < sorted.size (); ++i)
    if (sorted[i] != static_cast<std::int32_t> (i))
      return "every sample once along the line";
  if (static_cast<std::int32_t> (sorted.size ()) != complex.samples->size ())
    return "every sample along the line";
  for (std::size_t i = 0; i + 2 < complex.line.size (); ++i)
    if (dot (fromTo<Number> (p.col (complex.line[i]), p.col (complex.line[i + 1])),
             fromTo<Number> (p.col (complex.line[i + 1]), p.col (complex.line[i + 2]))) <= 0)
      return broken ("order along the line", i);
  return "";
}

/** \brief The dimension of the affine hull of a cloud; exact. */
template <typename Number>
int
affineDimension (const Eigen::Matrix3Xd& p)
{
  int dimension = 0;
  Vector<Number> first{};
  Vector<Number> normal{};
  for (Eigen::Index i = 1; i < p.cols (); ++i) {
    const Vector<Number> v = fromTo<Number> (p.col (0), p.col (i));
    if (dimension == 0 && !isZero (v)) {
      first = v;
      dimension = 1;
    } else if (dimension == 1 && !isZero (cross (first, v))) {
      normal = cross (first, v);
      dimension = 2;
    } else if (dimension == 2 && dot (normal, v) != 0) {
      return 3;
    }
  }
  return dimension;
}

/** \brief Everything that the headers promise. */
template <typename Number>
std::string
brokenPromise (const DelaunayComplex& complex)
{
  if (complex.affine_dimension != affineDimension<Number> (complex.samples->points))
    return "affine dimension";
  std::string broken = brokenArrays (complex);
  if (broken.empty ())
    broken = brokenNeighbors (complex);
  if (complex.affine_dimension < 2)
    return broken.empty () ? brokenLine<Number> (complex) : broken;
  if (broken.empty ())
    broken = brokenOrientation<Number> (complex);
  if (complex.affine_dimension == 2)
    return broken.empty () ? brokenPlane<Number> (complex) : broken;
  if (broken.empty ())
    broken = brokenEmptySpheres<Number> (complex);
  return broken.empty () ? brokenCounts<Number> (complex) : broken;
}

} // namespace oracle
