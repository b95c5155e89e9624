// The simulated lidar: rays against brute force, and what the sweeps promise.
#include <generate/lidar.h>
#include <generate/random.h>
#include <generate/ray_scene.h>
#include <generate/village.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <stdexcept>
#include <vector>

namespace {

using namespace generate;
using Eigen::Vector3d;

constexpr Truth THING{2, 7};

std::optional<RayHit>
castAt (const RayScene& scene, const Vector3d& from, const Vector3d& towards, double to = 100.0)
{
  return scene.cast ({from, (towards - from).normalized ()}, 0.0, to);
}

TEST (RayScene, EmptySceneIsNeverHit)
{
  RayScene scene (0.0);
  EXPECT_FALSE (castAt (scene, {0, 0, 0}, {0, 0, 1}));
  scene.build ();
  EXPECT_FALSE (castAt (scene, {0, 0, 0}, {0, 0, 1}));
}

TEST (RayScene, TriangleIsHitFromBothSidesAndOnlyInside)
{
  RayScene scene (0.0);
  scene.addTriangle ({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, THING);
  scene.build ();
  for (const double side : {-3.0, 3.0}) {
    const auto hit = castAt (scene, {0.2, 0.2, side}, {0.2, 0.2, 0});
    ASSERT_TRUE (hit);
    EXPECT_NEAR (hit->range, 3.0, 1e-12);
    EXPECT_EQ (hit->truth.object, 7U);
    EXPECT_FALSE (hit->partial);
    EXPECT_FALSE (castAt (scene, {0.2, 0.2, side}, {0.7, 0.7, 0}));
    EXPECT_FALSE (castAt (scene, {0.2, 0.2, side}, {0.2, 0.2, 0}, 2.9));
  }
  EXPECT_FALSE (castAt (scene, {-1, 0.2, 0}, {0, 0.2, 0})); // in its plane
}

TEST (RayScene, ThickRodIsHitAtItsSurfaceAndThinOneWhereTheBeamTouchesIt)
{
  RayScene scene (0.1);
  scene.addRod ({0, 0, 0}, {0, 0, 2}, 0.5, THING);
  scene.addRod ({0, 10, 0}, {0, 10, 2}, 0.01, THING);
  scene.build ();
  const auto thick = castAt (scene, {5, 0, 1}, {0, 0, 1});
  ASSERT_TRUE (thick);
  EXPECT_NEAR (thick->range, 4.5, 1e-12);
  EXPECT_FALSE (thick->partial);
  const auto thin = castAt (scene, {5, 10.09, 1}, {0, 10.09, 1});
  ASSERT_TRUE (thin);
  EXPECT_NEAR (thin->range, 5.0, 1e-12);
  EXPECT_TRUE (thin->partial);
  EXPECT_FALSE (castAt (scene, {5, 10.11, 1}, {0, 10.11, 1}));
  EXPECT_FALSE (castAt (scene, {5, 10, 2.2}, {0, 10, 2.2})); // above its end
  EXPECT_FALSE (castAt (scene, {0, 10, 5}, {0, 10, 4}));     // along its axis
}

TEST (RayScene, GroundIsFoundWhereTheRayMeetsIt)
{
  RayScene scene (0.0);
  scene.setGround (villageGround, 0.21, THING);
  scene.build ();
  Random random (3);
  for (int i = 0; i < 500; ++i) {
    const Vector3d from (0, 0, 20), towards (random.uniform (-60, 60), random.uniform (-60, 60), 0.0);
    const auto hit = castAt (scene, from, towards, 500.0);
    ASSERT_TRUE (hit);
    const Vector3d place = from + hit->range * (towards - from).normalized ();
    EXPECT_NEAR (place.z (), villageGround (place.x (), place.y ()), 1e-4);
  }
  EXPECT_FALSE (castAt (scene, {0, 0, 20}, {0, 0, 21}));
}

TEST (RayScene, TreeOfBoxesFindsWhatBruteForceFinds)
{
  Random random (5);
  RayScene all (0.05);
  std::vector<RayScene> single;
  for (std::uint32_t i = 0; i < 300; ++i) {
    const Vector3d a = 4.0 * random.cube ();
    const Vector3d b = a + 0.8 * random.direction (), c = a + 0.8 * random.direction ();
    single.emplace_back (0.05);
    for (RayScene* scene : {&all, &single.back ()}) {
      if (i % 3 == 0)
        scene->addTriangle (a, b, c, {2, i});
      else if (i % 3 == 1)
        scene->addDisc (a, (b - a).normalized (), 0.3, {3, i});
      else
        scene->addRod (a, b, i % 2 == 0 ? 0.02 : 0.2, {1, i});
    }
    single.back ().build ();
  }
  all.build ();
  int hits = 0;
  for (int i = 0; i < 1000; ++i) {
    const Ray ray{4.0 * random.cube (), random.direction ()};
    std::optional<RayHit> nearest;
    for (const RayScene& scene : single) {
      const auto hit = scene.cast (ray, 0.5, 6.0);
      if (hit && (!nearest || hit->range < nearest->range))
        nearest = hit;
    }
    const auto found = all.cast (ray, 0.5, 6.0);
    ASSERT_EQ (found.has_value (), nearest.has_value ());
    if (!found)
      continue;
    ++hits;
    EXPECT_EQ (found->range, nearest->range);
    EXPECT_EQ (found->truth.object, nearest->truth.object);
  }
  EXPECT_GT (hits, 100);
}

class Sweep : public testing::TestWithParam<LabelledCloud (*) (const LidarSettings&, const Tick&)>
{
protected:
  static LidarSettings settings (std::size_t points)
  {
    LidarSettings result;
    result.points = points;
    return result;
  }

  LabelledCloud sweep (const LidarSettings& how) const { return GetParam () (how, {}); }
};

TEST_P (Sweep, GivesAboutThePointsThatWereAskedFor)
{
  for (const std::size_t count : {5000U, 40000U}) {
    const double ratio = static_cast<double> (sweep (settings (count)).size ()) / static_cast<double> (count);
    EXPECT_GT (ratio, 0.85);
    EXPECT_LT (ratio, 1.2);
  }
}

TEST_P (Sweep, SameSeedSamePoints)
{
  LidarSettings how = settings (5000);
  const LabelledCloud once = sweep (how), twice = sweep (how);
  EXPECT_EQ (once.points, twice.points);
  EXPECT_EQ (once.labels, twice.labels);
  how.seed = 2;
  EXPECT_NE (sweep (how).points, once.points);
}

TEST_P (Sweep, ThingsHaveTheirLabelsAndAreWhereTheyStand)
{
  const LabelledCloud cloud = sweep (settings (40000));
  const std::map<LidarClass, std::vector<std::uint32_t>> labels = {{LidarClass::GROUND, {2}},
                                                                   {LidarClass::VEGETATION, {2, 3}},
                                                                   {LidarClass::BUILDING, {2}},
                                                                   {LidarClass::WIRE, {1}},
                                                                   {LidarClass::POLE, {1}}};
  std::map<LidarClass, int> counts;
  for (std::size_t i = 0; i < cloud.size (); ++i) {
    const Vector3d& point = cloud.points[i];
    const auto thing = static_cast<LidarClass> (cloud.object[i]);
    ++counts[thing];
    ASSERT_EQ (std::count (labels.at (thing).begin (), labels.at (thing).end (), cloud.labels[i]), 1);
    ASSERT_LE (std::abs (point.x ()), VILLAGE_HALF_LENGTH + 0.2);
    ASSERT_LE (std::abs (point.y ()), VILLAGE_HALF_WIDTH + 0.2);
    const double above = point.z () - villageGround (point.x (), point.y ());
    ASSERT_GT (above, -0.2);
    if (thing == LidarClass::GROUND) {
      ASSERT_LT (above, 0.2);
      // Nothing is seen of the ground inside of the larger house.
      ASSERT_GT (std::hypot (point.x () + 20.0, point.y () - 17.0), 3.0);
    }
    if (thing == LidarClass::WIRE) {
      ASSERT_GT (above, 4.0);
    }
  }
  EXPECT_EQ (counts.size (), labels.size ());
  for (const auto& [thing, count] : counts)
    EXPECT_GT (count, 40) << static_cast<int> (thing);
}

TEST_P (Sweep, BadSettingsAreRefused)
{
  EXPECT_THROW (sweep (settings (0)), std::invalid_argument);
  LidarSettings how = settings (1000);
  how.range_noise = -0.1;
  EXPECT_THROW (sweep (how), std::invalid_argument);
}

INSTANTIATE_TEST_SUITE_P (Lidar, Sweep, testing::Values (&lidarAerial, &lidarTerrestrial));

} // namespace
