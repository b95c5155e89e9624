#include "scales/scale_ladder.h"

#include <pcl/manifold/bulk_box.h>

#include "points/nearest_neighbors.h"
#include "points/spacing.h"
#include "points/thinning.h"

#include <algorithm>
#include <cmath>

namespace pcl {
namespace manifold {

namespace {

// With fewer samples there is no neighbourhood to tell a dimension from.
constexpr Eigen::Index FEWEST_SAMPLES = 5;
// A shape is to be seen through eight samples or more across the whole cloud.
constexpr double COARSEST_SHARE = 1.0 / 8.0;

Eigen::Matrix3Xd
columns (const Eigen::Matrix3Xd& points, const std::vector<std::int32_t>& which)
{
  Eigen::Matrix3Xd chosen (3, static_cast<Eigen::Index> (which.size ()));
  for (std::size_t i = 0; i < which.size (); ++i)
    chosen.col (static_cast<Eigen::Index> (i)) = points.col (which[i]);
  return chosen;
}

// The samples of a level while the ladder is built.
struct Rung
{
  Eigen::Matrix3Xd kept;      // a point of the cloud each
  Eigen::Matrix3Xd sums;      // of all points that a sample stands for
  std::vector<double> counts; // of these
};

Rung
thin (const Rung& below, double spacing, ScaleLevel& level)
{
  const std::vector<std::uint8_t> flags = thinBySpacing (below.kept, spacing);
  std::vector<std::int32_t> kept;
  for (std::size_t i = 0; i < flags.size (); ++i)
    if (flags[i] != 0)
      kept.push_back (static_cast<std::int32_t> (i));
  Rung rung;
  rung.kept = columns (below.kept, kept);
  level.spacing = spacing;
  level.sample_of = nearestPoints (rung.kept, below.kept);
  rung.sums = Eigen::Matrix3Xd::Zero (3, rung.kept.cols ());
  rung.counts.assign (kept.size (), 0.0);
  for (std::size_t i = 0; i < level.sample_of.size (); ++i) {
    rung.sums.col (level.sample_of[i]) += below.sums.col (static_cast<Eigen::Index> (i));
    rung.counts[level.sample_of[i]] += below.counts[i];
  }
  level.centers.resize (3, rung.kept.cols ());
  for (Eigen::Index i = 0; i < rung.kept.cols (); ++i)
    level.centers.col (i) = rung.sums.col (i) / rung.counts[static_cast<std::size_t> (i)];
  return rung;
}

} // namespace

std::vector<ScaleLevel>
makeLadder (const Eigen::Matrix3Xd& points, const ScaleRange& range)
{
  const double step = std::sqrt (2.0);
  const double median = medianSpacing (points);
  const double finest = std::isfinite (median) ? median : 0.0;
  const double extent = bulkBox (points).sizes ().maxCoeff ();
  const double coarsest = range.to > 0.0 ? range.to : extent * COARSEST_SHARE;
  std::vector<ScaleLevel> levels (1);
  levels.front ().spacing = finest;
  levels.front ().centers = points;
  Rung rung{points, points, std::vector<double> (static_cast<std::size_t> (points.cols ()), 1.0)};
  double spacing = std::max (finest * step, range.from);
  for (; finest > 0.0 && spacing <= coarsest && rung.kept.cols () >= FEWEST_SAMPLES; spacing *= step) {
    ScaleLevel level;
    rung = thin (rung, spacing, level);
    if (rung.kept.cols () < FEWEST_SAMPLES)
      break;
    levels.push_back (std::move (level));
  }
  return levels;
}

} // namespace manifold
} // namespace pcl
