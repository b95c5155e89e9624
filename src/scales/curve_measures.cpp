#include "scales/curve_measures.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl {
namespace manifold {

std::vector<CurveMeasures>
measureCurves (const SampleSet& samples, const PersistentLabels& labels)
{
  const auto count = static_cast<std::size_t> (labels.curves);
  std::vector<CurveMeasures> curves (count);
  std::vector<Eigen::Vector3d> mean (count, Eigen::Vector3d::Zero ());
  std::vector<Eigen::Matrix3d> moments (count, Eigen::Matrix3d::Zero ());
  const auto forEachPoint = [&] (const auto& body) {
    for (std::size_t i = 0; i < labels.curve.size (); ++i)
      if (labels.curve[i] >= 0)
        body (static_cast<std::size_t> (labels.curve[i]), static_cast<Eigen::Index> (i));
  };
  std::vector<std::size_t> members (count, 0);
  forEachPoint ([&] (std::size_t curve, Eigen::Index i) {
    ++members[curve];
    mean[curve] += samples.points.col (i);
    curves[curve].mean_radius += labels.offset[static_cast<std::size_t> (i)];
  });
  for (std::size_t curve = 0; curve < count; ++curve) {
    mean[curve] /= static_cast<double> (members[curve]);
    curves[curve].mean_radius /= static_cast<double> (members[curve]) * samples.scale;
  }
  forEachPoint ([&] (std::size_t curve, Eigen::Index i) {
    const Eigen::Vector3d to = samples.points.col (i) - mean[curve];
    moments[curve] += to * to.transpose ();
  });
  for (std::size_t curve = 0; curve < count; ++curve)
    curves[curve].direction =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> (moments[curve]).eigenvectors ().col (2);
  struct Interval
  {
    double low = 0.0, high = 0.0;
    void take (double x) { low = std::min (low, x), high = std::max (high, x); }
  };
  std::vector<Interval> along (count), upward (count);
  forEachPoint ([&] (std::size_t curve, Eigen::Index i) {
    const Eigen::Vector3d to = samples.points.col (i) - mean[curve];
    along[curve].take (to.dot (curves[curve].direction));
    upward[curve].take (to.z ());
  });
  for (std::size_t curve = 0; curve < count; ++curve) {
    curves[curve].length = (along[curve].high - along[curve].low) / samples.scale;
    curves[curve].height = (upward[curve].high - upward[curve].low) / samples.scale;
    curves[curve].verticality = std::abs (curves[curve].direction.z ());
  }
  for (const std::int32_t sample : samples.sample_of)
    if (sample >= 0 && labels.curve[static_cast<std::size_t> (sample)] >= 0)
      ++curves[static_cast<std::size_t> (labels.curve[static_cast<std::size_t> (sample)])].points;
  return curves;
}

} // namespace manifold
} // namespace pcl
