#pragma once

#include "oracle_exact.h"
#include "oracle_lattice.h"

#include "extraction/facet_set.h"
#include "fixed_point/dual_edge.h"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <vector>

/** \file
 * The restricted Delaunay operator by its definition, without rounding: every Delaunay triangle against every
 * piece, every Voronoi edge cut out of a line by the bisectors with all samples. */

namespace oracle {

/** \brief For the lattice clouds: no number here has more than 20 times the bits of a coordinate. */
using WideInteger = boost::multiprecision::int512_t;

/** \brief The numbers s that satisfy linear inequalities, as a closed interval. */
template <typename Number>
class Interval
{
public:
  /** \brief Leaves the s with constant + slope * s >= 0. */
  void atLeastZero (const Number& constant, const Number& slope)
  {
    if (slope == 0)
      empty_ = empty_ || constant < 0;
    else if (slope > 0)
      raise (Number (-constant), slope);
    else
      lower (constant, Number (-slope));
  }

  void zero (const Number& constant, const Number& slope)
  {
    atLeastZero (constant, slope);
    atLeastZero (Number (-constant), Number (-slope));
  }

  bool empty () const
  {
    return empty_ || (low_denominator_ != 0 && high_denominator_ != 0 &&
                      low_ * high_denominator_ > high_ * low_denominator_);
  }

private:
  void raise (const Number& numerator, const Number& denominator)
  {
    if (low_denominator_ == 0 || numerator * low_denominator_ > low_ * denominator) {
      low_ = numerator;
      low_denominator_ = denominator;
    }
  }

  void lower (const Number& numerator, const Number& denominator)
  {
    if (high_denominator_ == 0 || numerator * high_denominator_ < high_ * denominator) {
      high_ = numerator;
      high_denominator_ = denominator;
    }
  }

  bool empty_ = false;
  Number low_ = 0;
  Number low_denominator_ = 0; // 0: unbounded
  Number high_ = 0;
  Number high_denominator_ = 0;
};

/** \brief The Voronoi edge dual to a triangle. */
template <typename Number>
class VoronoiEdge
{
public:
  explicit VoronoiEdge (const std::array<Eigen::Vector3d, 3>& triangle) : origin_ (triangle[0])
  {
    const Vector<Number> u = fromTo<Number> (triangle[0], triangle[1]);
    const Vector<Number> v = fromTo<Number> (triangle[0], triangle[2]);
    direction_ = cross (u, v);
    center_ = centerOf (u, v);
    center_.denominator *= 2;
  }

  /** \brief Leaves the points that are not nearer to another sample. */
  void cut (const Eigen::Vector3d& sample)
  {
    const Vector<Number> v = fromTo<Number> (origin_, sample);
    part_.atLeastZero (center_.denominator * dot (v, v) - 2 * dot (v, center_.numerator),
                       Number (-2 * dot (v, direction_)));
  }

  bool empty () const { return part_.empty (); }

  /** \brief Whether a closed triangle, segment or point has a point of the edge. */
  bool meets (const std::array<Eigen::Vector3d, 3>& piece) const
  {
    Interval<Number> part = part_;
    const Vector<Number> normal =
      cross (fromTo<Number> (piece[0], piece[1]), fromTo<Number> (piece[0], piece[2]));
    if (isZero (normal)) {
      cutToSegment (piece, part);
      return !part.empty ();
    }
    const Linear plane = along (normal, piece[0]);
    part.zero (plane.constant, plane.slope);
    for (std::size_t i = 0; i < 3; ++i) {
      const Linear inwards = along (cross (normal, fromTo<Number> (piece[i], piece[(i + 1) % 3])), piece[i]);
      part.atLeastZero (inwards.constant, inwards.slope);
    }
    return !part.empty ();
  }

  /** \brief Of the circumradius, as numerator / denominator. */
  std::array<Number, 2> squaredRadius () const
  {
    return {dot (center_.numerator, center_.numerator), Number (center_.denominator * center_.denominator)};
  }

  bool hasSameCenter (const VoronoiEdge& other) const
  {
    const Vector<Number> between = fromTo<Number> (origin_, other.origin_);
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (center_.numerator[axis] * other.center_.denominator !=
          (between[axis] * other.center_.denominator + other.center_.numerator[axis]) * center_.denominator)
        return false;
    return true;
  }

private:
  struct Linear
  {
    Number constant;
    Number slope;
  };

  // w (x - p) for the points x = origin + (center + s direction) / denominator, times the denominator.
  Linear along (const Vector<Number>& w, const Eigen::Vector3d& p) const
  {
    return {dot (w, fromTo<Number> (p, origin_)) * center_.denominator + dot (w, center_.numerator),
            dot (w, direction_)};
  }

  void cutToSegment (const std::array<Eigen::Vector3d, 3>& piece, Interval<Number>& part) const
  {
    // Between the two corners farthest from each other.
    Eigen::Vector3d a = piece[0];
    Eigen::Vector3d b = piece[0];
    Vector<Number> e{Number (0), Number (0), Number (0)};
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector<Number> side = fromTo<Number> (piece[i], piece[(i + 1) % 3]);
      if (dot (side, side) > dot (e, e)) {
        a = piece[i];
        b = piece[(i + 1) % 3];
        e = side;
      }
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      Vector<Number> unit{Number (0), Number (0), Number (0)};
      unit[axis] = 1;
      const Linear beside = along (isZero (e) ? unit : cross (e, unit), a);
      part.zero (beside.constant, beside.slope);
    }
    const Linear ahead = along (e, a);
    part.atLeastZero (ahead.constant, ahead.slope);
    const Linear behind = along (e, b);
    part.atLeastZero (Number (-behind.constant), Number (-behind.slope));
  }

  Eigen::Vector3d origin_;
  Vector<Number> direction_;
  Center<Number> center_; // from the origin; numerator / denominator
  Interval<Number> part_;
};

inline std::array<Eigen::Vector3d, 3>
trianglePoints (const pcl::manifold::DelaunayComplex& complex, const pcl::manifold::Facet& facet)
{
  const std::array<std::int32_t, 3> samples = facetOf (complex, facet.cell, facet.facet);
  const Eigen::Matrix3Xd& points = complex.samples->points;
  return {points.col (samples[0]), points.col (samples[1]), points.col (samples[2])};
}

/** \brief Every Delaunay triangle of a complex with its Voronoi edge. */
struct RestrictedOracle
{
  std::vector<pcl::manifold::Facet> facets;
  std::vector<VoronoiEdge<WideInteger>> edges;

  explicit RestrictedOracle (const pcl::manifold::DelaunayComplex& complex)
  {
    for (std::size_t i = 0; i < complex.cells.size (); ++i)
      for (int k = 0; k < 4; ++k) {
        const pcl::manifold::Facet facet{static_cast<std::int32_t> (i), k};
        const std::array<std::int32_t, 3> samples = facetOf (complex, facet.cell, facet.facet);
        if (facet.cell > complex.neighbors[i][static_cast<std::size_t> (k)] ||
            *std::min_element (samples.begin (), samples.end ()) < 0)
          continue;
        facets.push_back (facet);
        edges.emplace_back (trianglePoints (complex, facet));
        for (Eigen::Index v = 0; v < complex.samples->points.cols (); ++v)
          edges.back ().cut (complex.samples->points.col (v));
      }
  }

  /** \brief The triangles that a piece generates, ascending. */
  std::vector<pcl::manifold::Facet> generatedBy (const std::array<Eigen::Vector3d, 3>& piece) const
  {
    std::vector<pcl::manifold::Facet> result;
    for (std::size_t i = 0; i < facets.size (); ++i)
      if (edges[i].meets (piece))
        result.push_back (facets[i]);
    return result;
  }
};

/** \brief Pieces that have something to do with a lattice cloud: of its points, of points between these, of
 * lattice points around; some as flat as a segment or a point. A cloud with even coordinates has more of
 * these. */
inline std::array<Eigen::Vector3d, 3>
latticePiece (const Eigen::Matrix3Xd& cloud, Random& random)
{
  const int kind = random.index (6);
  const Eigen::Vector3d low = cloud.rowwise ().minCoeff ();
  const Eigen::Vector3d high = cloud.rowwise ().maxCoeff ();
  const auto anySample = [&] () -> Eigen::Vector3d {
    return cloud.col (random.index (static_cast<int> (cloud.cols ())));
  };
  std::array<Eigen::Vector3d, 3> piece;
  for (Eigen::Vector3d& corner : piece) {
    if (kind == 0 || (kind == 1 && random.coin ())) {
      corner = anySample ();
    } else if (kind <= 2) {
      corner = (0.5 * (anySample () + anySample ())).array ().floor ();
    } else {
      // Inside of the box, or around it.
      const double margin = kind == 3 ? 0.0 : 1.0;
      for (int axis = 0; axis < 3; ++axis) {
        const double size = margin * (high[axis] - low[axis] + 2);
        corner[axis] = std::floor (random.uniform (low[axis] - size, high[axis] + size + 1));
      }
    }
  }
  if (random.index (6) == 0) {
    const int flat = random.index (3);
    if (flat == 0)
      piece[2] = piece[0];
    else if (flat == 1)
      piece[2] = 2 * piece[1] - piece[0];
    else
      piece[1] = piece[2] = piece[0];
  }
  return piece;
}

} // namespace oracle
