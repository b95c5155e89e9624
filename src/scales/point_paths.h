#pragma once

#include "scales/level_evidence.h"
#include "scales/scale_ladder.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace manifold {

/** The label of a point, and the consecutive levels [begin, end) that say so. */
struct Choice
{
  std::uint8_t label = 2;
  std::uint8_t begin = 0, end = 0;
};

/** The samples that stand for a point on the levels, -1 where a level was left out. */
using Path = std::vector<std::int32_t>;

/** The way of every point up the ladder, and through the pieces of curves of all levels, which are numbered
 * through. */
class PointPaths
{
public:
  PointPaths (const std::vector<ScaleLevel>& levels, const std::vector<LevelEvidence>& evidence)
    : levels_ (levels), evidence_ (evidence), first_piece_ (1, 0)
  {
    for (const LevelEvidence& level : evidence)
      first_piece_.push_back (first_piece_.back () + static_cast<std::uint32_t> (level.pieces));
  }

  std::size_t points () const { return static_cast<std::size_t> (levels_.front ().centers.cols ()); }

  std::size_t levels () const { return levels_.size (); }

  std::uint32_t pieces () const { return first_piece_.back (); }

  /** \param[out] path of as many entries as there are levels */
  void find (std::size_t point, Path& path) const
  {
    path.resize (levels ());
    auto sample = static_cast<std::int32_t> (point);
    for (std::size_t level = 0; level < levels (); ++level) {
      if (level > 0)
        sample = levels_[level].sample_of[static_cast<std::size_t> (sample)];
      path[level] = evidence_[level].dimension.empty () ? -1 : sample;
    }
  }

  /** The number of the piece that a path passes on a level, or -1. */
  std::int64_t pieceAt (const Path& path, std::size_t level) const
  {
    if (path[level] < 0)
      return -1;
    const std::int32_t piece = evidence_[level].piece[static_cast<std::size_t> (path[level])];
    return piece < 0 ? -1 : static_cast<std::int64_t> (first_piece_[level]) + piece;
  }

private:
  const std::vector<ScaleLevel>& levels_;
  const std::vector<LevelEvidence>& evidence_;
  std::vector<std::uint32_t> first_piece_;
};

} // namespace manifold
} // namespace pcl
