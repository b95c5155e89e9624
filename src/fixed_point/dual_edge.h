#pragma once

#include "fixed_point/filtered_number.h"
#include "fixed_point/number_vector.h"

#include <Eigen/Core>

#include <array>

namespace pcl {
namespace manifold {

/** A flat piece: the triangle of three points, which may coincide or lie on a line. */
using Piece = std::array<Eigen::Vector3d, 3>;

/** The Voronoi edge dual to a Delaunay triangle: the points of the line through its circumcentre orthogonal
 * to it that are not nearer to the opposite samples of its two cells; only one of these or none where the
 * triangle is on the hull. */
struct DualEdge
{
  std::array<Eigen::Vector3d, 3> triangle; ///< not on a line
  std::array<Eigen::Vector3d, 2> opposite; ///< off the plane of the triangle, the first `bounds` of them
  int bounds = 0;
};

/** Whether a piece meets a Voronoi edge, decided exactly for any finite coordinates.
 *
 * Both are closed sets, so that touching counts as meeting. Samples on an empty sphere, whose centre is an
 * end of many Voronoi edges and a whole Voronoi edge of length zero besides, thus stay together: what meets
 * the centre meets all of these. Nothing is perturbed. */
bool meets (const Piece& piece, const DualEdge& edge);

/** The same by exact numbers alone. */
bool meetsExactly (const Piece& piece, const DualEdge& edge);

/** Whether a piece is known to meet a Voronoi edge in one point inside of both. */
bool crosses (const Piece& piece, const DualEdge& edge);

enum class Answer
{
  NO,
  YES, ///< in one point inside of both
  UNCERTAIN
};

/** Which of the Voronoi edges around the Voronoi face between two samples a piece meets, as far as doubles
 * can tell. What the edges have in common is computed once. */
class FaceFilter
{
public:
  using Excesses = NumberVector<FilteredNumber>;

  FaceFilter (const Piece& piece, const Eigen::Vector3d& p, const Eigen::Vector3d& q) : image_ (piece, p, q)
  {}

  /** How much farther the corners of the piece are from another sample than from p. */
  Excesses excesses (const Eigen::Vector3d& sample) const { return image_.excesses (sample); }

  /** Whether the piece meets the Voronoi edge of p, q and a third sample.
   * \param[in] third excesses over this sample
   * \param[in] behind, ahead excesses over the opposite samples of its two cells, or null */
  Answer meets (const Excesses& third, const Excesses* behind, const Excesses* ahead) const
  {
    const Excesses weights = image_.weights (third);
    const int sign = signOf (weights[0]);
    const int second = signOf (weights[1]);
    const int last = signOf (weights[2]);
    if (sign * second < 0 || sign * last < 0 || second * last < 0)
      return Answer::NO;
    if (sign == 0 || second == 0 || last == 0)
      return Answer::UNCERTAIN;
    for (const Excesses* bound : {behind, ahead}) {
      const int side = bound == nullptr ? 1 : sign * signOf (dot (weights, *bound));
      if (side <= 0)
        return side < 0 ? Answer::NO : Answer::UNCERTAIN;
    }
    return Answer::YES;
  }

private:
  FaceImage<FilteredNumber> image_;
};

} // namespace manifold
} // namespace pcl
