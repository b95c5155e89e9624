#include "scales/curve_pieces.h"

#include "common/parallel.h"
#include "complex/disjoint_sets.h"

namespace pcl {
namespace manifold {

namespace {

bool
isOfCurve (const Choice& choice, std::size_t level)
{
  return choice.label == 1 && choice.begin <= level && level < choice.end;
}

// Calls body (point, level, piece) for all pieces that points pass.
template <typename Body>
void
forEachPiece (const PointPaths& paths, const Body& body)
{
  Path path;
  for (std::size_t point = 0; point < paths.points (); ++point) {
    paths.find (point, path);
    for (std::size_t level = 0; level < paths.levels (); ++level)
      if (const std::int64_t piece = paths.pieceAt (path, level); piece >= 0)
        body (point, level, static_cast<std::uint32_t> (piece));
  }
}

} // namespace

void
adoptByPieces (const PointPaths& paths, std::vector<Choice>& choices)
{
  std::vector<std::uint32_t> members (paths.pieces (), 0), sure (paths.pieces (), 0);
  forEachPiece (paths, [&] (std::size_t point, std::size_t level, std::uint32_t piece) {
    ++members[piece];
    sure[piece] += isOfCurve (choices[point], level) ? 1 : 0;
  });
  parallelRanges (paths.points (), [&] (std::size_t begin, std::size_t end) {
    Path path;
    for (std::size_t point = begin; point < end; ++point) {
      if (choices[point].label == 1)
        continue;
      paths.find (point, path);
      Choice best;
      for (std::size_t level = 0, first = 0; level < paths.levels (); ++level) {
        const std::int64_t piece = paths.pieceAt (path, level);
        if (piece < 0 ||
            4 * sure[static_cast<std::size_t> (piece)] < 3 * members[static_cast<std::size_t> (piece)])
          first = level + 1;
        else if (level + 1 - first > static_cast<std::size_t> (best.end - best.begin))
          best = {1, static_cast<std::uint8_t> (first), static_cast<std::uint8_t> (level + 1)};
      }
      if (best.label == 1)
        choices[point] = best;
    }
  });
}

std::int32_t
joinCurves (const PointPaths& paths, const std::vector<Choice>& choices, std::vector<std::int32_t>& curve)
{
  DisjointSets sets (paths.pieces ());
  std::vector<std::int64_t> piece_of (paths.points (), -1);
  forEachPiece (paths, [&] (std::size_t point, std::size_t level, std::uint32_t piece) {
    if (!isOfCurve (choices[point], level))
      return;
    if (piece_of[point] >= 0)
      sets.join (static_cast<std::uint32_t> (piece_of[point]), piece);
    piece_of[point] = piece;
  });
  std::int32_t count = 0;
  std::vector<std::int32_t> number (paths.pieces (), -1);
  curve.assign (paths.points (), -1);
  for (std::size_t point = 0; point < paths.points (); ++point)
    if (piece_of[point] >= 0) {
      std::int32_t& of_set = number[sets.find (static_cast<std::uint32_t> (piece_of[point]))];
      if (of_set < 0)
        of_set = count++;
      curve[point] = of_set;
    }
  return count;
}

} // namespace manifold
} // namespace pcl
