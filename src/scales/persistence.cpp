#include "scales/persistence.h"

#include "common/parallel.h"
#include "complex/disjoint_sets.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl {
namespace manifold {

namespace {

// A curve as long as 64 spacings at one level, or 8 at two levels.
constexpr float CURVE_OCTAVES = 6.0f;
constexpr float OCTAVES_PER_LEVEL = 0.5f;
// So many of the nearest points outvote one in whether it is of a surface or a solid.
constexpr int MAJORITY = 7;

// Consecutive levels [begin, end) that say the same.
struct Run
{
  float weight = 0.0f;
  std::size_t begin = 0, end = 0;
};

// Grows with the levels, remembers the heaviest run.
class Runs
{
public:
  // What a level adds: nothing or less ends the run.
  void add (std::size_t level, float weight)
  {
    if (weight <= 0.0f) {
      current_ = Run ();
      return;
    }
    if (current_.weight == 0.0f)
      current_.begin = level;
    current_.weight += weight;
    current_.end = level + 1;
    ++levels_;
    if (current_.weight > best_.weight)
      best_ = current_;
  }

  const Run& best () const { return best_; }

  // Of all runs.
  std::size_t levels () const { return levels_; }

private:
  Run current_, best_;
  std::size_t levels_ = 0;
};

float
curveOctaves (const LevelEvidence& evidence, std::size_t sample)
{
  const float labelled = evidence.manifold_dimension[sample] == 1 ? 1.0f : 0.0f;
  return evidence.length[sample] > 0.0f ? std::max (labelled, std::log2 (evidence.length[sample])) : labelled;
}

struct Choice
{
  int label = 2;
  Run run;
};

// The samples of a point on the levels, -1 where a level was left out.
using Path = std::vector<std::int32_t>;

Choice
choose (const std::vector<LevelEvidence>& evidence, const Path& path)
{
  Runs curve, surface, solid;
  for (std::size_t level = 0; level < path.size (); ++level) {
    if (path[level] < 0)
      continue;
    const LevelEvidence& here = evidence[level];
    const auto sample = static_cast<std::size_t> (path[level]);
    // Sure of nothing is still a label.
    const float sure = std::max (here.confidence[sample], std::numeric_limits<float>::min ());
    curve.add (level, curveOctaves (here, sample));
    surface.add (level, here.manifold_dimension[sample] == 2 && here.flat[sample] != 0 ? sure : 0.0f);
    solid.add (level, here.manifold_dimension[sample] == 3 ? sure : 0.0f);
  }
  // A tree is as tall as thin from afar, but a solid at more scales than it is a curve.
  const std::size_t others = std::max (surface.levels (), solid.levels ());
  if (curve.best ().weight >= std::max (CURVE_OCTAVES, static_cast<float> (others)))
    return {1, curve.best ()};
  if (solid.best ().weight > surface.best ().weight)
    return {3, solid.best ()};
  if (surface.best ().weight > 0.0f)
    return {2, surface.best ()};
  // No level fits, or there are too few of them for a short curve: as the finest says.
  const auto finest = static_cast<std::size_t> (
    std::find_if (path.begin (), path.end (), [] (std::int32_t sample) { return sample >= 0; }) -
    path.begin ());
  const auto label = evidence[finest].manifold_dimension[static_cast<std::size_t> (path[finest])];
  return {label, {0.0f, finest, finest + 1}};
}

// Surfaces and solids are thicker than a point: single ones that differ from those around them are mistaken.
void
outvote (const std::vector<pcl::index_t>& neighbors, std::vector<std::uint8_t>& labels)
{
  if (neighbors.empty ())
    return;
  const std::vector<std::uint8_t> chosen = labels;
  parallelFor (labels.size (), [&] (std::size_t i) {
    if (chosen[i] == 1)
      return;
    const std::uint8_t other = chosen[i] == 2 ? 3 : 2;
    const pcl::index_t* voters = neighbors.data () + i * NEAREST;
    if (std::count_if (voters, voters + NEAREST, [&] (pcl::index_t q) { return chosen[q] == other; }) >=
        MAJORITY)
      labels[i] = other;
  });
}

} // namespace

PersistentLabels
choosePersistent (const std::vector<ScaleLevel>& levels, const std::vector<LevelEvidence>& evidence,
                  const std::vector<pcl::index_t>& neighbors)
{
  const auto n = static_cast<std::size_t> (levels.front ().centers.cols ());
  PersistentLabels result;
  result.manifold_dimension.resize (n);
  result.dimension.resize (n);
  result.boundary.resize (n);
  result.confidence.resize (n);
  result.scale.resize (n);
  result.persistence.resize (n);
  result.tangent = Eigen::Matrix3Xf::Zero (3, static_cast<Eigen::Index> (n));
  result.offset.assign (n, 0.0f);

  // The pieces of all levels are numbered through.
  std::vector<std::uint32_t> first_piece (evidence.size () + 1, 0);
  for (std::size_t level = 0; level < evidence.size (); ++level)
    first_piece[level + 1] = first_piece[level] + static_cast<std::uint32_t> (evidence[level].pieces);
  std::vector<std::int32_t> piece_of (n, -1); // of a point of a curve: its longest piece

  const auto pathOf = [&] (std::size_t point, Path& path) {
    auto sample = static_cast<std::int32_t> (point);
    for (std::size_t level = 0; level < levels.size (); ++level) {
      if (level > 0)
        sample = levels[level].sample_of[sample];
      path[level] = evidence[level].dimension.empty () ? -1 : sample;
    }
  };
  parallelRanges (n, [&] (std::size_t begin, std::size_t end) {
    Path path (levels.size ());
    for (std::size_t point = begin; point < end; ++point) {
      pathOf (point, path);
      const Choice choice = choose (evidence, path);
      const LevelEvidence& finest = evidence[choice.run.begin];
      const auto sample = static_cast<std::size_t> (path[choice.run.begin]);
      result.manifold_dimension[point] = static_cast<std::uint8_t> (choice.label);
      result.dimension[point] = finest.dimension[sample];
      result.boundary[point] = finest.boundary[sample];
      result.scale[point] = static_cast<float> (finest.spacing);
      result.persistence[point] = OCTAVES_PER_LEVEL * static_cast<float> (choice.run.end - choice.run.begin);
      float confidence = 0.0f, longest = -1.0f;
      for (std::size_t level = choice.run.begin; level < choice.run.end; ++level) {
        const auto here = static_cast<std::size_t> (path[level]);
        confidence += evidence[level].confidence[here];
        if (choice.label != 1 || evidence[level].length[here] <= longest)
          continue;
        longest = evidence[level].length[here];
        result.tangent.col (static_cast<Eigen::Index> (point)) =
          evidence[level].direction.col (static_cast<Eigen::Index> (here));
        const Eigen::Vector3d to = levels.front ().centers.col (static_cast<Eigen::Index> (point)) -
                                   levels[level].centers.col (static_cast<Eigen::Index> (here));
        result.offset[point] = static_cast<float> (
          to.cross (result.tangent.col (static_cast<Eigen::Index> (point)).cast<double> ()).norm ());
        if (evidence[level].piece[here] >= 0)
          piece_of[point] = static_cast<std::int32_t> (first_piece[level]) + evidence[level].piece[here];
      }
      result.confidence[point] = confidence / static_cast<float> (choice.run.end - choice.run.begin);
    }
  });

  outvote (neighbors, result.manifold_dimension);

  // Points of curves join the pieces that they belong to on the levels of their runs.
  DisjointSets sets (first_piece.back ());
  Path path (levels.size ());
  for (std::size_t point = 0; point < n; ++point) {
    if (piece_of[point] < 0)
      continue;
    pathOf (point, path);
    const Run run = choose (evidence, path).run;
    for (std::size_t level = run.begin; level < run.end; ++level) {
      const std::int32_t piece = evidence[level].piece[static_cast<std::size_t> (path[level])];
      if (piece >= 0)
        sets.join (static_cast<std::uint32_t> (piece_of[point]),
                   first_piece[level] + static_cast<std::uint32_t> (piece));
    }
  }
  // Curves are numbered by their first points.
  result.curve.assign (n, -1);
  std::vector<std::int32_t> number (first_piece.back (), -1);
  for (std::size_t point = 0; point < n; ++point)
    if (piece_of[point] >= 0) {
      std::int32_t& curve = number[sets.find (static_cast<std::uint32_t> (piece_of[point]))];
      if (curve < 0)
        curve = result.curves++;
      result.curve[point] = curve;
    }
  return result;
}

void
toSpace (const SensorCoordinates& sensor, const Eigen::Matrix3Xd& points, PersistentLabels& labels)
{
  parallelFor (labels.scale.size (), [&] (std::size_t i) {
    const auto column = static_cast<Eigen::Index> (i);
    const auto width = static_cast<float> (sensor.widthAt (points.col (column)));
    labels.scale[i] *= width;
    labels.offset[i] *= width;
    if (labels.manifold_dimension[i] == 1)
      labels.tangent.col (column) =
        sensor.toSpace (points.col (column), labels.tangent.col (column).cast<double> ()).cast<float> ();
  });
}

} // namespace manifold
} // namespace pcl
