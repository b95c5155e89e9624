#include "dimension_methods.h"

#include <pcl/manifold/detect_dimensions.h>
#include <pcl/manifold/scale_dimensions.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/point_types.h>

namespace evaluate {

namespace {

using pcl::manifold::DimensionParameters;
using pcl::manifold::StageLog;
using pcl::manifold::Status;

// A curve whose direction has at least this cosine against z is upright.
constexpr float UPRIGHT = 0.9f;

double
secondsSince (std::chrono::steady_clock::time_point start)
{
  return std::chrono::duration<double> (std::chrono::steady_clock::now () - start).count ();
}

double
ratio (std::size_t part, std::size_t all)
{
  return all == 0 ? 0.0 : static_cast<double> (part) / static_cast<double> (all);
}

} // namespace

void
CurveScore::count (Curve truth, bool found)
{
  if (truth == Curve::YES)
    ++(found ? hits : misses);
  else if (truth == Curve::NO)
    ++(found ? false_alarms : rejections);
}

double
CurveScore::accuracy () const
{
  return ratio (hits + rejections, hits + rejections + misses + false_alarms);
}

double
CurveScore::precision () const
{
  return ratio (hits, hits + false_alarms);
}

double
CurveScore::recall () const
{
  return ratio (hits, hits + misses);
}

double
CurveScore::f1 () const
{
  return ratio (2 * hits, 2 * hits + misses + false_alarms);
}

CurveScore
scoreOf (const LabelledPoints& truth, const Answers& answers, bool upright)
{
  CurveScore score;
  for (std::size_t i = 0; i < answers.dimension.size (); ++i)
    score.count (truth.curve[i], answers.dimension[i] == 1 && (!upright || answers.upright[i] != 0));
  return score;
}

double
medianSpacing (const Eigen::Matrix3Xd& points)
{
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud (new pcl::PointCloud<pcl::PointXYZ>);
  for (Eigen::Index i = 0; i < points.cols (); ++i) {
    const Eigen::Vector3f p = points.col (i).cast<float> ();
    cloud->push_back ({p.x (), p.y (), p.z ()});
  }
  pcl::KdTreeFLANN<pcl::PointXYZ> tree;
  tree.setInputCloud (cloud);
  std::vector<float> nearest;
  pcl::Indices indices;
  std::vector<float> squared;
  for (const pcl::PointXYZ& point : *cloud)
    if (tree.nearestKSearch (point, 2, indices, squared) == 2)
      nearest.push_back (squared[1]);
  if (nearest.empty ())
    return 0.0;
  const auto middle = nearest.begin () + static_cast<std::ptrdiff_t> (nearest.size () / 2);
  std::nth_element (nearest.begin (), middle, nearest.end ());
  return std::sqrt (*middle);
}

Answers
detectAtAllScales (const Eigen::Matrix3Xd& points, unsigned int threads)
{
  DimensionParameters parameters;
  parameters.threads = threads;
  StageLog log;
  std::shared_ptr<const pcl::manifold::ScaleDimensions> found;
  Answers answers;
  const auto start = std::chrono::steady_clock::now ();
  if (pcl::manifold::detectScales (points, {}, pcl::manifold::FLOAT_RESOLUTION, parameters, {}, log, found) !=
      Status::OK)
    return answers;
  answers.seconds = secondsSince (start);
  for (const std::int32_t sample : found->samples->sample_of) {
    if (sample < 0) {
      answers.dimension.push_back (0);
      answers.upright.push_back (0);
      continue;
    }
    const auto at = static_cast<std::size_t> (sample);
    const std::int32_t curve = found->curve[at];
    const double up = curve >= 0 ? found->curves[static_cast<std::size_t> (curve)].verticality
                                 : std::abs (found->tangents (2, sample));
    answers.dimension.push_back (found->manifold_dimension[at]);
    answers.upright.push_back (up > UPRIGHT ? 1 : 0);
  }
  return answers;
}

LevelAnswers
detectAtOneLevel (const Eigen::Matrix3Xd& points, double thin_distance, unsigned int threads)
{
  DimensionParameters parameters;
  parameters.threads = threads;
  parameters.thinning.distance = thin_distance;
  StageLog log;
  std::shared_ptr<const pcl::manifold::SampleDimensions> found;
  LevelAnswers answers;
  const auto start = std::chrono::steady_clock::now ();
  if (pcl::manifold::detectDimensions (points, {}, pcl::manifold::FLOAT_RESOLUTION, parameters, log, found) !=
      Status::OK)
    return answers;
  answers.published.seconds = answers.manifold.seconds = secondsSince (start);
  const auto label = [] (const std::vector<std::uint8_t>& labels, std::int32_t sample) {
    return sample < 0 ? std::uint8_t{0} : labels[static_cast<std::size_t> (sample)];
  };
  for (const std::int32_t sample : found->complex->samples->sample_of) {
    answers.published.dimension.push_back (label (found->dimension, sample));
    answers.manifold.dimension.push_back (label (found->manifold_dimension, sample));
  }
  return answers;
}

} // namespace evaluate
