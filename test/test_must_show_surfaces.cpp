// Whole reconstructions of shapes of known topology.
#include "test_must_show_models.h"

#include <generate/catalogue.h>
#include <generate/curves.h>
#include <generate/sampling.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

namespace {

using must_show::Evaluation;

constexpr std::uint64_t SEEDS = 5;
// The guarantees of the papers hold for samples as dense as this share of the feature size.
constexpr double EPS = 0.1;

class Closed : public testing::TestWithParam<std::string>
{
protected:
  const generate::Shape shape = generate::shapeByName (GetParam ());

  void expectExact (const Eigen::Matrix3Xd& points, double used, double watertight_used,
                    std::uint64_t seed) const
  {
    const Evaluation open = must_show::reconstruct (points, false);
    EXPECT_EQ (open.complaints (must_show::expectedOf (shape, used)), "") << "seed " << seed;
    EXPECT_TRUE (open.topology.surface.isClosed ()) << "seed " << seed;
    const Evaluation watertight = must_show::reconstruct (points, true, open.dimensions);
    EXPECT_EQ (watertight.complaints (must_show::closed (shape.topology.euler, watertight_used)), "")
      << "watertight, seed " << seed;
  }
};

TEST_P (Closed, DenseSamplesAreExact)
{
  for (std::uint64_t seed = 1; seed <= SEEDS; ++seed)
    expectExact (must_show::pointsOf (generate::epsilonSample (shape, EPS, seed)), 1.0, 1.0, seed);
}

TEST_P (Closed, RandomSamplesAreExact)
{
  for (std::uint64_t seed = 1; seed <= SEEDS; ++seed)
    expectExact (must_show::pointsOf (generate::uniform (shape, 10000, seed)), 0.99, 0.998, seed);
}

INSTANTIATE_TEST_SUITE_P (Shapes, Closed, testing::Values ("sphere", "torus", "genus3"),
                          [] (const auto& tested) { return tested.param; });

TEST (Trefoil, DenseSamplesAreOneKnot)
{
  const generate::Shape trefoil = generate::trefoil ();
  for (std::uint64_t seed = 1; seed <= SEEDS; ++seed) {
    const Eigen::Matrix3Xd points = must_show::pointsOf (generate::epsilonSample (trefoil, EPS, seed));
    const Evaluation knot = must_show::reconstruct (points, false);
    const pcl::manifold::CurveTopology& curve = knot.topology.curve;
    EXPECT_TRUE (knot.shape.triangles.empty ());
    EXPECT_TRUE (knot.shape.tetrahedra.empty ());
    ASSERT_EQ (curve.components.size (), 1U) << "seed " << seed;
    EXPECT_TRUE (curve.components.front ().closed);
    EXPECT_EQ (curve.vertices, knot.samples);
  }
}

class Open : public testing::TestWithParam<std::string>
{
protected:
  const generate::Shape shape = generate::shapeByName (GetParam ());
};

TEST_P (Open, EvenSamplesKeepTheirRims)
{
  const double spacing = generate::spacingFor (shape, 5000);
  for (std::uint64_t seed = 1; seed <= SEEDS; ++seed) {
    const Evaluation sheet =
      must_show::reconstruct (must_show::pointsOf (generate::blueNoise (shape, spacing, seed)), false);
    EXPECT_EQ (sheet.complaints (must_show::expectedOf (shape, 0.998)), "") << "seed " << seed;
  }
}

// Specks beside the rim may come off, but the sheet itself has to be what it is.
TEST_P (Open, RandomSamplesKeepTheirRims)
{
  for (std::uint64_t seed = 1; seed <= SEEDS; ++seed) {
    const Evaluation sheet =
      must_show::reconstruct (must_show::pointsOf (generate::uniform (shape, 10000, seed)), false);
    ASSERT_FALSE (sheet.topology.surface.components.empty ()) << "seed " << seed;
    const pcl::manifold::SurfaceComponent& largest = sheet.topology.surface.components.front ();
    EXPECT_TRUE (sheet.topology.surface.isManifold ()) << "seed " << seed;
    EXPECT_EQ (largest.euler_characteristic, shape.topology.euler) << "seed " << seed;
    EXPECT_EQ (largest.boundary_loops, static_cast<std::size_t> (shape.topology.boundary_components))
      << "seed " << seed;
    EXPECT_EQ (largest.orientable, shape.topology.orientable) << "seed " << seed;
    EXPECT_GE (sheet.used (), 0.975) << "seed " << seed;
  }
}

TEST_P (Open, WatertightIsClosed)
{
  const double spacing = generate::spacingFor (shape, 5000);
  for (std::uint64_t seed = 1; seed <= SEEDS; ++seed) {
    const Evaluation skin =
      must_show::reconstruct (must_show::pointsOf (generate::blueNoise (shape, spacing, seed)), true);
    EXPECT_EQ (skin.complaints (must_show::closed (std::nullopt, 0.0)), "") << "seed " << seed;
  }
}

INSTANTIATE_TEST_SUITE_P (Shapes, Open,
                          testing::Values ("hemisphere", "annulus", "moebius", "terrain", "cylinder"),
                          [] (const auto& tested) { return tested.param; });

} // namespace
