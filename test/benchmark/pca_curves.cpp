#include "pca_curves.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>
#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/point_types.h>

namespace evaluate {

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

/** Sums over neighbours, from which their spread follows. */
struct Moments
{
  double count = 0.0;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero ();
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero ();

  void add (const Eigen::Vector3d& to)
  {
    ++count;
    sum += to;
    squares += to * to.transpose ();
  }

  // Linearity, planarity and scattering: not negative, with the sum 1. All 0 for less than a handful.
  std::array<double, 3> features () const
  {
    constexpr double HANDFUL = 5.0;
    if (count < HANDFUL)
      return {};
    const Eigen::Vector3d mean = sum / count;
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
    solver.computeDirect (squares / count - mean * mean.transpose (), Eigen::EigenvaluesOnly);
    const Eigen::Vector3d sigma = solver.eigenvalues ().cwiseMax (0.0).cwiseSqrt ();
    if (!(sigma[2] > 0.0))
      return {};
    return {(sigma[2] - sigma[1]) / sigma[2], (sigma[1] - sigma[0]) / sigma[2], sigma[0] / sigma[2]};
  }
};

Cloud::Ptr
cloudOf (const Eigen::Matrix3Xd& points)
{
  Cloud::Ptr cloud (new Cloud);
  for (Eigen::Index i = 0; i < points.cols (); ++i) {
    const Eigen::Vector3f p = points.col (i).cast<float> ();
    cloud->push_back ({p.x (), p.y (), p.z ()});
  }
  return cloud;
}

double
entropy (const std::array<double, 3>& features)
{
  double sum = 0.0;
  for (const double feature : features)
    sum -= feature > 0.0 ? feature * std::log (feature) : 0.0;
  return sum;
}

} // namespace

Answers
pcaOfLeastEntropy (const Eigen::Matrix3Xd& points)
{
  constexpr std::array<std::size_t, 8> COUNTS = {10, 14, 20, 28, 40, 56, 80, 100};
  Answers answers;
  const auto start = std::chrono::steady_clock::now ();
  pcl::KdTreeFLANN<pcl::PointXYZ> tree;
  const Cloud::Ptr cloud = cloudOf (points);
  tree.setInputCloud (cloud);
  pcl::Indices indices;
  std::vector<float> squared;
  for (Eigen::Index i = 0; i < points.cols (); ++i) {
    tree.nearestKSearch ((*cloud)[static_cast<std::size_t> (i)], COUNTS.back (), indices, squared);
    Moments moments;
    double least = std::numeric_limits<double>::infinity ();
    std::uint8_t answer = 0;
    auto next = COUNTS.begin ();
    for (const pcl::index_t index : indices) {
      moments.add (points.col (index) - points.col (i));
      if (next == COUNTS.end () || moments.count < static_cast<double> (*next))
        continue;
      ++next;
      const std::array<double, 3> features = moments.features ();
      if (entropy (features) < least) {
        least = entropy (features);
        answer = static_cast<std::uint8_t> (
          1 + std::distance (features.begin (), std::max_element (features.begin (), features.end ())));
      }
    }
    answers.dimension.push_back (answer);
  }
  answers.seconds = std::chrono::duration<double> (std::chrono::steady_clock::now () - start).count ();
  return answers;
}

TunedPca
tunePca (const LabelledPoints& truth, double spacing)
{
  constexpr int RADII = 10, FIRST = 50, LAST = 98;
  constexpr std::size_t ASKED = 30000;
  std::vector<Eigen::Index> asked;
  for (std::size_t i = 0; i < truth.curve.size (); ++i)
    if (truth.curve[i] != Curve::NOT_ASKED)
      asked.push_back (static_cast<Eigen::Index> (i));
  const std::size_t step = std::max<std::size_t> (1, asked.size () / ASKED);

  pcl::KdTreeFLANN<pcl::PointXYZ> tree (false);
  const Cloud::Ptr cloud = cloudOf (truth.points);
  tree.setInputCloud (cloud);
  pcl::Indices indices;
  std::vector<float> squared;
  TunedPca best;
  for (int power = 1; power <= RADII; ++power) {
    const double radius = 2.0 * spacing * std::pow (std::sqrt (2.0), power);
    std::vector<CurveScore> scores (LAST + 1);
    for (std::size_t at = 0; at < asked.size (); at += step) {
      const Eigen::Index i = asked[at];
      Moments moments;
      tree.radiusSearch ((*cloud)[static_cast<std::size_t> (i)], radius, indices, squared);
      for (const pcl::index_t index : indices)
        moments.add (truth.points.col (index) - truth.points.col (i));
      const double linearity = moments.features ()[0];
      for (int percent = FIRST; percent <= LAST; percent += 2)
        scores[static_cast<std::size_t> (percent)].count (truth.curve[static_cast<std::size_t> (i)],
                                                          linearity > percent / 100.0);
    }
    for (int percent = FIRST; percent <= LAST; percent += 2) {
      const CurveScore& score = scores[static_cast<std::size_t> (percent)];
      if (power == 1 && percent == FIRST)
        best = {radius, percent / 100.0, score};
      if (score.f1 () > best.score.f1 ())
        best = {radius, percent / 100.0, score};
    }
  }
  return best;
}

} // namespace evaluate
