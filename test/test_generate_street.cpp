// Spinning lidars in a street: the rings of their sensors, the things around them, and registered frames.
#include <generate/lidar_sweeps.h>
#include <generate/spinning_lidar.h>
#include <generate/street.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace generate;
using Eigen::Vector3d;

constexpr double DEGREE = 3.14159265358979323846 / 180.0;
constexpr double EYE = 1.73;

LidarSettings
settings (std::size_t points)
{
  LidarSettings result;
  result.points = points;
  return result;
}

TEST (SpinningLidar, HasTheRingsOfRealSensors)
{
  EXPECT_THROW (spinningLidar (0), std::invalid_argument);
  EXPECT_THROW (spinningLidar (-16), std::invalid_argument);
  EXPECT_THROW (spinningLidar (20), std::invalid_argument);
  const std::map<int, std::pair<double, double>> ends = {
    {16, {-15.0, 15.0}}, {32, {-30.67, 10.67}}, {64, {-24.8, 2.0}}};
  for (const auto& [rings, range] : ends) {
    const SpinningLidar sensor = spinningLidar (rings);
    ASSERT_EQ (sensor.elevations.size (), static_cast<std::size_t> (rings));
    EXPECT_NEAR (sensor.elevations.front (), range.first * DEGREE, 1e-12);
    EXPECT_NEAR (sensor.elevations.back (), range.second * DEGREE, 1e-12);
    EXPECT_TRUE (std::is_sorted (sensor.elevations.begin (), sensor.elevations.end ()));
  }
  EXPECT_NEAR (spinningLidar (16).elevations[1], -13.0 * DEGREE, 1e-12);
}

class Frame : public testing::TestWithParam<int>
{
protected:
  static LabelledCloud frame (const LidarSettings& how) { return lidarFrame (GetParam (), how); }
};

TEST_P (Frame, BadSettingsAreRefused)
{
  LidarSettings how = settings (1000);
  how.range_noise = -0.1;
  EXPECT_THROW (frame (how), std::invalid_argument);
}

TEST_P (Frame, PointsLieOnTheRingsOfTheSensor)
{
  const SpinningLidar sensor = spinningLidar (GetParam ());
  const LabelledCloud cloud = frame (settings (8000));
  std::vector<int> on_ring (sensor.elevations.size (), 0);
  for (const Vector3d& point : cloud.points) {
    const double elevation = std::asin (point.z () / point.norm ());
    const auto nearest =
      std::min_element (sensor.elevations.begin (), sensor.elevations.end (), [&] (double a, double b) {
        return std::abs (a - elevation) < std::abs (b - elevation);
      });
    ASSERT_NEAR (*nearest, elevation, 1e-9);
    ++on_ring[static_cast<std::size_t> (nearest - sensor.elevations.begin ())];
    ASSERT_LT (point.norm (), 80.2);
    ASSERT_GT (point.norm (), 0.8);
  }
  for (std::size_t ring = 0; ring < on_ring.size (); ++ring)
    EXPECT_GT (on_ring[ring], 0) << ring;
}

TEST_P (Frame, GivesAboutThePointsThatWereAskedFor)
{
  for (const std::size_t count : {5000U, 20000U}) {
    const double ratio = static_cast<double> (frame (settings (count)).size ()) / static_cast<double> (count);
    EXPECT_GT (ratio, 0.85);
    EXPECT_LT (ratio, 1.15);
  }
}

TEST_P (Frame, TurnsAsTheSensorDoesIfNoNumberIsGiven)
{
  const SpinningLidar sensor = spinningLidar (GetParam ());
  const double pulses = 360.0 * DEGREE / sensor.step * static_cast<double> (GetParam ());
  const auto count = static_cast<double> (frame (settings (0)).size ());
  EXPECT_GT (count, 0.5 * pulses);
  EXPECT_LT (count, 0.981 * pulses);
}

TEST_P (Frame, SameSeedSamePoints)
{
  LidarSettings how = settings (4000);
  const LabelledCloud once = frame (how), twice = frame (how);
  EXPECT_EQ (once.points, twice.points);
  EXPECT_EQ (once.labels, twice.labels);
  EXPECT_EQ (once.object, twice.object);
  how.seed = 2;
  EXPECT_NE (frame (how).points, once.points);
}

TEST_P (Frame, ThingsHaveTheirLabelsAndAreWhereTheyStand)
{
  const LabelledCloud cloud = frame (settings (GetParam () == 16 ? 0 : 40000));
  const std::map<LidarClass, std::set<std::uint32_t>> labels = {
    {LidarClass::GROUND, {2}}, {LidarClass::VEGETATION, {2, 3}}, {LidarClass::BUILDING, {2}},
    {LidarClass::ROAD, {2}},   {LidarClass::WIRE, {1}},          {LidarClass::POLE, {1}},
    {LidarClass::FENCE, {1}},  {LidarClass::SIGN, {2}},          {LidarClass::CAR, {2}}};
  std::map<LidarClass, int> counts;
  for (std::size_t i = 0; i < cloud.size (); ++i) {
    const Vector3d& point = cloud.points[i];
    const auto thing = static_cast<LidarClass> (cloud.object[i]);
    ++counts[thing];
    ASSERT_EQ (labels.at (thing).count (cloud.labels[i]), 1U);
    ASSERT_GT (point.z (), -EYE - 0.3);
    ASSERT_LT (std::abs (point.y ()), 45.0 + 2.0);
    if (thing == LidarClass::ROAD) {
      ASSERT_LT (point.z (), -EYE + 0.3);
      ASSERT_LT (std::abs (point.y ()), PAVEMENT_END + 1.5 + 0.2);
    }
    if (thing == LidarClass::WIRE) {
      ASSERT_GT (point.z (), 3.0);
    }
  }
  for (const LidarClass thing : {LidarClass::ROAD, LidarClass::BUILDING, LidarClass::VEGETATION,
                                 LidarClass::POLE, LidarClass::FENCE, LidarClass::CAR})
    EXPECT_GT (counts[thing], 10) << static_cast<int> (thing);
}

INSTANTIATE_TEST_SUITE_P (Rings, Frame, testing::Values (16, 32, 64));

TEST (LidarMap, IsTheStreetInCoordinatesOfTheFirstFrame)
{
  LidarSettings how = settings (30000);
  const LabelledCloud map = lidarMap (64, how), again = lidarMap (64, how);
  EXPECT_EQ (map.points, again.points);
  EXPECT_EQ (map.labels, again.labels);
  EXPECT_NEAR (static_cast<double> (map.size ()), 30000.0, 3000.0);
  double error = 0.0, count = 0.0;
  for (std::size_t i = 0; i < map.size (); ++i) {
    const Vector3d& point = map.points[i];
    ASSERT_GT (point.x (), -81.0);
    ASSERT_LT (point.x (), 96.0);
    // The road right under the drive is flat: what is off there is the noise of poses and ranges.
    if (map.object[i] == static_cast<std::uint32_t> (LidarClass::ROAD) && std::abs (point.y ()) < 1.0) {
      error += std::abs (point.z () + EYE);
      ++count;
    }
  }
  ASSERT_GT (count, 100.0);
  EXPECT_LT (error / count, 0.08);
  EXPECT_GT (error / count, 0.005);
  how.seed = 2;
  EXPECT_NE (lidarMap (64, how).points, map.points);
  how.range_noise = -1.0;
  EXPECT_THROW (lidarMap (64, how), std::invalid_argument);
}

TEST (LidarSweeps, HaveNamesOfTheirOwn)
{
  std::set<std::string> names;
  for (const LidarSweep& sweep : lidarSweeps ())
    EXPECT_TRUE (names.insert (sweep.name).second) << sweep.name;
  EXPECT_EQ (names.size (), 6U);
}

} // namespace
