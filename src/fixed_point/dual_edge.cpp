#include "fixed_point/dual_edge.h"

#include "fixed_point/exact_number.h"
#include "fixed_point/lattice.h"

#include <algorithm>

namespace pcl {
namespace manifold {

namespace {

/** The part of the line of an edge in a piece whose image is in a line through the origin, as the convex hull
 * of a few points: the corners on the line of the edge, and where sides of the piece cross it. */
template <typename Number>
class Overlap
{
public:
  Overlap (const NumberVector<Number>& f, const NumberVector<Number>& g)
  {
    for (int i = 0; i < 3; ++i) {
      if (signOf (f[i]) == 0 && signOf (g[i]) == 0)
        points_[count_++] = {i, Number (1), i, Number (0)};
      const int k = (i + 1) % 3;
      const NumberVector<Number>& across = signOf (f[i]) != 0 ? f : g;
      const int side = signOf (across[i]);
      if (side * signOf (across[k]) < 0)
        points_[count_++] = {i, Number (-side) * across[k], k, Number (side) * across[i]};
    }
  }

  bool empty () const { return count_ == 0; }

  /** The sign of the largest excess of its points, given those of the corners. */
  int largestSign (const NumberVector<Number>& excesses) const
  {
    int largest = -1;
    for (int i = 0; i < count_; ++i) {
      const Point& point = points_[i];
      largest = std::max (largest, signOf (Number (point.first_weight * excesses[point.first] +
                                                   point.second_weight * excesses[point.second])));
    }
    return largest;
  }

private:
  /** A point of a side of the piece as a sum of its ends; weights are not negative. */
  struct Point
  {
    int first;
    Number first_weight;
    int second;
    Number second_weight;
  };

  std::array<Point, 6> points_;
  int count_ = 0;
};

template <typename Number>
bool
meetsWithoutRounding (const Piece& piece, const DualEdge& edge)
{
  const FaceImage<Number> image (piece, edge.triangle[2], edge.triangle[0]);
  const NumberVector<Number> g = image.excesses (edge.triangle[1]);
  const NumberVector<Number> weights = image.weights (g);
  const int total = signOf (Number (weights[0] + weights[1] + weights[2]));
  if (total != 0) {
    for (const Number& weight : weights)
      if (signOf (weight) * total < 0)
        return false;
    for (int bound = 0; bound < edge.bounds; ++bound)
      if (signOf (dot (weights, image.excesses (edge.opposite[bound]))) * total < 0)
        return false;
    return true;
  }
  // The image is in a line: the piece is parallel to the edge, or flatter than a triangle. Where it meets the
  // line of the edge, it does so in an interval, which meets the edge if it meets the ray on either side.
  for (const Number& weight : weights)
    if (signOf (weight) != 0)
      return false; // a line beside the origin
  const Overlap<Number> overlap (image.f, g);
  if (overlap.empty ())
    return false;
  for (int bound = 0; bound < edge.bounds; ++bound)
    if (overlap.largestSign (image.excesses (edge.opposite[bound])) < 0)
      return false;
  return true;
}

Answer
meetsFiltered (const Piece& piece, const DualEdge& edge)
{
  const FaceFilter filter (piece, edge.triangle[2], edge.triangle[0]);
  std::array<FaceFilter::Excesses, 2> bounds;
  for (int bound = 0; bound < edge.bounds; ++bound)
    bounds[bound] = filter.excesses (edge.opposite[bound]);
  return filter.meets (filter.excesses (edge.triangle[1]), edge.bounds > 0 ? &bounds[0] : nullptr,
                       edge.bounds > 1 ? &bounds[1] : nullptr);
}

} // namespace

bool
meetsExactly (const Piece& piece, const DualEdge& edge)
{
  std::array<Eigen::Vector3d, 8> points{piece[0],         piece[1],         piece[2],
                                        edge.triangle[0], edge.triangle[1], edge.triangle[2],
                                        edge.triangle[2], edge.triangle[2]};
  std::copy_n (edge.opposite.begin (), edge.bounds, points.begin () + 6);
  if (!moveToLattice (points))
    return meetsWithoutRounding<ExactNumber> (piece, edge);
  return meetsWithoutRounding<LatticeNumber> (
    {points[0], points[1], points[2]},
    {{points[3], points[4], points[5]}, {points[6], points[7]}, edge.bounds});
}

bool
meets (const Piece& piece, const DualEdge& edge)
{
  const Answer answer = meetsFiltered (piece, edge);
  return answer == Answer::UNCERTAIN ? meetsExactly (piece, edge) : answer == Answer::YES;
}

bool
crosses (const Piece& piece, const DualEdge& edge)
{
  return meetsFiltered (piece, edge) == Answer::YES;
}

} // namespace manifold
} // namespace pcl
