#include "scales/persistence.h"

#include "common/parallel.h"
#include "scales/curve_pieces.h"
#include "scales/point_paths.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl {
namespace manifold {

namespace {

// A curve as long as 32 spacings at one level, or about 6 at two levels.
constexpr float CURVE_OCTAVES = 5.0f;
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

Choice
choiceOf (int label, const Run& run)
{
  return {static_cast<std::uint8_t> (label), static_cast<std::uint8_t> (run.begin),
          static_cast<std::uint8_t> (run.end)};
}

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
    return choiceOf (1, curve.best ());
  if (solid.best ().weight > surface.best ().weight)
    return choiceOf (3, solid.best ());
  if (surface.best ().weight > 0.0f)
    return choiceOf (2, surface.best ());
  // No level fits, or there are too few of them for a short curve: as the finest says.
  const auto finest = static_cast<std::size_t> (
    std::find_if (path.begin (), path.end (), [] (std::int32_t sample) { return sample >= 0; }) -
    path.begin ());
  const auto label = evidence[finest].manifold_dimension[static_cast<std::size_t> (path[finest])];
  return choiceOf (label, {0.0f, finest, finest + 1});
}

// Surfaces and solids are thicker than a point: single ones that differ from those around them are mistaken.
void
outvote (const std::vector<pcl::index_t>& neighbors, std::vector<Choice>& choices)
{
  if (neighbors.empty ())
    return;
  const std::vector<Choice> chosen = choices;
  parallelFor (choices.size (), [&] (std::size_t i) {
    if (chosen[i].label == 1)
      return;
    const std::uint8_t other = chosen[i].label == 2 ? 3 : 2;
    const pcl::index_t* voters = neighbors.data () + i * NEAREST;
    if (std::count_if (voters, voters + NEAREST, [&] (pcl::index_t q) { return chosen[q].label == other; }) >=
        MAJORITY)
      choices[i].label = other;
  });
}

} // namespace

PersistentLabels
choosePersistent (const std::vector<ScaleLevel>& levels, const std::vector<LevelEvidence>& evidence,
                  const std::vector<pcl::index_t>& neighbors)
{
  const PointPaths paths (levels, evidence);
  const std::size_t n = paths.points ();
  std::vector<Choice> choices (n);
  parallelRanges (n, [&] (std::size_t begin, std::size_t end) {
    Path path;
    for (std::size_t point = begin; point < end; ++point) {
      paths.find (point, path);
      choices[point] = choose (evidence, path);
    }
  });
  outvote (neighbors, choices);
  adoptByPieces (paths, choices);

  PersistentLabels result;
  result.manifold_dimension.resize (n);
  result.dimension.resize (n);
  result.boundary.resize (n);
  result.confidence.resize (n);
  result.scale.resize (n);
  result.persistence.resize (n);
  result.tangent = Eigen::Matrix3Xf::Zero (3, static_cast<Eigen::Index> (n));
  result.offset.assign (n, 0.0f);
  parallelRanges (n, [&] (std::size_t begin, std::size_t end) {
    Path path;
    for (std::size_t point = begin; point < end; ++point) {
      paths.find (point, path);
      const Choice choice = choices[point];
      const LevelEvidence& finest = evidence[choice.begin];
      const auto sample = static_cast<std::size_t> (path[choice.begin]);
      result.manifold_dimension[point] = choice.label;
      result.dimension[point] = finest.dimension[sample];
      result.boundary[point] = finest.boundary[sample];
      result.scale[point] = static_cast<float> (finest.spacing);
      result.persistence[point] = OCTAVES_PER_LEVEL * static_cast<float> (choice.end - choice.begin);
      float confidence = 0.0f, longest = -1.0f;
      const auto column = static_cast<Eigen::Index> (point);
      for (std::size_t level = choice.begin; level < choice.end; ++level) {
        const std::int32_t here = path[level];
        const LevelEvidence& there = evidence[level];
        confidence += there.confidence[static_cast<std::size_t> (here)];
        if (choice.label != 1 || there.length[static_cast<std::size_t> (here)] <= longest)
          continue;
        longest = there.length[static_cast<std::size_t> (here)];
        result.tangent.col (column) = there.direction.col (here);
        const Eigen::Vector3d to = levels.front ().centers.col (column) - levels[level].centers.col (here);
        result.offset[point] =
          static_cast<float> (to.cross (there.direction.col (here).cast<double> ()).norm ());
      }
      result.confidence[point] = confidence / static_cast<float> (choice.end - choice.begin);
    }
  });
  result.curves = joinCurves (paths, choices, result.curve);
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
