// The published guarantee of FixedPointReconstruction: from 0.143-samples of smooth closed surfaces
// homeomorphic ones, near to them. The command evaluate_fixed_points does the same for any number of samples.
#include "test_must_show_fixed_points.h"

#include <generate/point_grid.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace {

using namespace must_show;
using pcl::manifold::CriticalPointParameters;

TEST (ProvedBounds, AreThoseOfThePaper)
{
  // Section 5: "when eps = 0.143, omega is about 0.0145".
  EXPECT_NEAR (provedBounds (GUARANTEED_EPS).distance, 0.0145, 5e-5);
  for (const double eps : {0.001, 0.01, 0.05}) {
    const double series = eps * eps * (0.5 + eps * (1.0 + eps * (17.0 / 8.0 + 5.0 * eps)));
    EXPECT_NEAR (provedBounds (eps).distance, series, 20.0 * std::pow (eps, 6));
  }
  // chi is about (1 + 4 / sqrt (3)) eps to begin with, and eta about eps.
  EXPECT_NEAR (provedBounds (1e-5).angle / 1e-5, 3.0 + 4.0 / std::sqrt (3.0), 1e-3);
}

class Guarantee : public testing::TestWithParam<std::string>
{};

TEST_P (Guarantee, HoldsForDenseSamples)
{
  const SmoothSurface surface = smoothSurface (GetParam ());
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Eigen::Matrix3Xd points = surface.sample (GUARANTEED_EPS, seed);
    const FixedPointEvaluation evaluation = reconstructFixedPoint (points, CriticalPointParameters ());
    Closeness closeness;
    EXPECT_EQ (guaranteeComplaints (surface, points, evaluation, closeness), "") << "seed " << seed;
    EXPECT_GT (closeness.distance, 0.0);
    EXPECT_EQ (sausageComplaints (surface, points, evaluation, seed), "") << "seed " << seed;
  }
}

// A 0.143-sample may be as uneven as it likes: rows of points, far denser than they are far from each other.
TEST (UnevenSamples, HaveTheGuaranteeToo)
{
  const SmoothSurface torus = smoothSurface ("torus"); // of feature size 0.4
  Eigen::Matrix3Xd points (3, 110 * 500);
  for (int row = 0; row < 110; ++row)
    for (int i = 0; i < 500; ++i) {
      const double a = 2.0 * M_PI * row / 110;
      const double b = 2.0 * M_PI * i / 500;
      const double out = 1.0 + 0.4 * std::cos (b);
      points.col (500 * row + i) << out * std::cos (a), out * std::sin (a), 0.4 * std::sin (b);
    }
  const FixedPointEvaluation evaluation = reconstructFixedPoint (points, CriticalPointParameters ());
  Closeness closeness;
  EXPECT_EQ (guaranteeComplaints (torus, points, evaluation, closeness), "");
}

// What the samples have to be for the guarantee.
TEST_P (Guarantee, IsTestedOnSamplesThatAreDenseEnough)
{
  const SmoothSurface surface = smoothSurface (GetParam ());
  const Eigen::Matrix3Xd points = surface.sample (GUARANTEED_EPS, 1);
  generate::PointGrid grid (GUARANTEED_EPS);
  for (const auto& point : points.colwise ())
    grid.insert (point);
  double farthest = 0.0;
  std::vector<Eigen::Vector3d> near;
  for (const Eigen::Vector3d& place : generate::uniform (surface.shape, 20000, 2).points) {
    grid.collectWithin (place, GUARANTEED_EPS, near);
    double nearest = GUARANTEED_EPS;
    for (const Eigen::Vector3d& point : near)
      nearest = std::min (nearest, (point - place).norm ());
    farthest = std::max (farthest, nearest / surface.feature_size (place));
  }
  EXPECT_LE (farthest, GUARANTEED_EPS);
  EXPECT_GE (farthest, 0.9 * GUARANTEED_EPS);
}

INSTANTIATE_TEST_SUITE_P (Surfaces, Guarantee, testing::ValuesIn (smoothSurfaceNames ()),
                          [] (const auto& tested) {
                            std::string name = tested.param;
                            std::replace (name.begin (), name.end (), '-', '_');
                            return name;
                          });

} // namespace
