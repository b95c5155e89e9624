// Dimensions in scenes of sphere, torus, trefoil and ball, with seeds that nothing was tuned on.
#include "test_must_show_scenes.h"

#include <generate/scenes.h>

#include <gtest/gtest.h>

namespace {

using must_show::DimensionScore;

// As many points as are customary on a sphere of radius 1.
constexpr std::size_t SPHERE_POINTS = 60000;

class BlueNoiseScene : public testing::TestWithParam<double>
{};

TEST_P (BlueNoiseScene, EveryPointIsRight)
{
  const double spacing = GetParam ();
  // The finest scene is large: one seed of it will do here.
  const std::uint64_t seeds = spacing < 0.06 ? 1 : 3;
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    const DimensionScore score =
      must_show::scoreDimensions (generate::mixedScene (spacing, 7000 + 10 * seed), 2.0 * spacing, 0);
    EXPECT_GT (score.asked, 1000U);
    EXPECT_EQ (score.right, score.asked) << "seed " << seed;
  }
}

INSTANTIATE_TEST_SUITE_P (Spacings, BlueNoiseScene, testing::Values (0.04, 0.06, 0.08, 0.10, 0.12),
                          [] (const auto& tested) {
                            return "Percent" + std::to_string (static_cast<int> (100.0 * tested.param + 0.5));
                          });

TEST (RandomScene, IsRightWhenThinned)
{
  for (const std::uint64_t seed : {7100, 7110}) {
    const DimensionScore score = must_show::scoreDimensions (
      generate::mixedSceneRandom (SPHERE_POINTS, seed), 2.0 * must_show::ballSpacing (SPHERE_POINTS, 24), 24);
    EXPECT_GE (score.share (), 0.999) << "seed " << seed << ": " << score.right << " of " << score.asked;
  }
}

TEST (NoisyScene, IsRightWhenThinnedMore)
{
  for (const std::uint64_t seed : {7200, 7210}) {
    generate::LabelledCloud cloud = generate::mixedSceneRandom (SPHERE_POINTS, seed);
    generate::addNoise (cloud, 0.01, seed + 5);
    const DimensionScore score =
      must_show::scoreDimensions (cloud, 2.0 * must_show::ballSpacing (SPHERE_POINTS, 48), 48);
    EXPECT_GE (score.share (), 0.995) << "seed " << seed << ": " << score.right << " of " << score.asked;
  }
}

} // namespace
