#include <generate/random.h>
#include <generate/spinning_lidar.h>
#include <generate/street.h>

#include <boost/math/constants/constants.hpp>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace generate {

namespace {

using boost::math::constants::degree;
using boost::math::constants::two_pi;
using Eigen::Vector3d;

constexpr double BEAM_RADIUS = 0.02, NEAREST = 1.0, FARTHEST = 80.0, LOST = 0.02;
// In the right one of two lanes.
constexpr double LANE = -1.3, EYE = 1.73;

SpinningLidar
evenRings (int rings, double lowest, double highest, double step)
{
  SpinningLidar sensor;
  for (int ring = 0; ring < rings; ++ring)
    sensor.elevations.push_back ((lowest + (highest - lowest) * ring / (rings - 1)) * degree<double> ());
  sensor.step = step * degree<double> ();
  return sensor;
}

// The sensor with the step that gives about as many points, if that was asked for.
SpinningLidar
sensorFor (int rings, int frames, const LidarSettings& settings)
{
  if (!(settings.range_noise >= 0.0))
    throw std::invalid_argument ("the noise of a lidar sweep must be 0 or more");
  SpinningLidar sensor = spinningLidar (rings);
  // Of all pulses, those that bring a point: as found for this scene.
  const double returns = rings == 64 ? 0.96 : rings == 32 ? 0.93 : 0.85;
  if (settings.points > 0)
    sensor.step = two_pi<double> () * rings * frames * returns / static_cast<double> (settings.points);
  return sensor;
}

Vector3d
placeAt (double along)
{
  return {along, LANE, streetGround (LANE) + EYE};
}

/** One turn, in coordinates of the sensor. */
LabelledCloud
turn (const RayScene& scene, const SpinningLidar& sensor, const Vector3d& place, double noise, Random& random)
{
  LabelledCloud cloud;
  const auto columns = static_cast<int> (two_pi<double> () / sensor.step);
  for (int column = 0; column < columns; ++column) {
    const double azimuth = (column + 0.5 * (random.uniform () - 0.5)) * sensor.step;
    for (const double elevation : sensor.elevations) {
      const Vector3d direction (std::cos (elevation) * std::cos (azimuth),
                                std::cos (elevation) * std::sin (azimuth), std::sin (elevation));
      const auto hit = scene.cast ({place, direction}, NEAREST, FARTHEST);
      if (hit && random.uniform () >= LOST)
        cloud.add ((hit->range + noise * random.normal ()) * direction, hit->truth.label, 0.0, false,
                   hit->truth.object);
    }
  }
  return cloud;
}

} // namespace

SpinningLidar
spinningLidar (int rings)
{
  switch (rings) {
    case 16:
      return evenRings (16, -15.0, 15.0, 0.2);
    case 32:
      return evenRings (32, -30.67, 10.67, 0.17);
    case 64:
      return evenRings (64, -24.8, 2.0, 0.17);
    default:
      throw std::invalid_argument ("a spinning lidar has 16, 32 or 64 rings");
  }
}

LabelledCloud
lidarFrame (int rings, const LidarSettings& settings, const Tick& tick)
{
  const SpinningLidar sensor = sensorFor (rings, 1, settings);
  if (tick)
    tick (0.0);
  const RayScene scene = street (BEAM_RADIUS, settings.seed);
  Random random (settings.seed + 1);
  return turn (scene, sensor, placeAt (0.0), settings.range_noise, random);
}

LabelledCloud
lidarMap (int rings, const LidarSettings& settings, const Tick& tick)
{
  constexpr int FRAMES = 16;
  constexpr double DRIVE = 15.0, OFF = 0.02, TURNED = 0.05;
  const SpinningLidar sensor = sensorFor (rings, FRAMES, settings);
  const RayScene scene = street (BEAM_RADIUS, settings.seed);
  Random random (settings.seed + 1);
  LabelledCloud map;
  for (int frame = 0; frame < FRAMES; ++frame) {
    if (tick)
      tick (static_cast<double> (frame) / FRAMES);
    const double along = DRIVE * frame / (FRAMES - 1);
    LabelledCloud seen = turn (scene, sensor, placeAt (along - 0.5 * DRIVE), settings.range_noise, random);
    Vector3d place (along, 0.0, 0.0), rotation;
    for (int axis = 0; axis < 3; ++axis) {
      place[axis] += OFF * random.normal ();
      rotation[axis] = TURNED * degree<double> () * random.normal ();
    }
    const Eigen::Matrix3d turned =
      Eigen::AngleAxisd (rotation.norm (), rotation.stableNormalized ()).toRotationMatrix ();
    for (Vector3d& point : seen.points)
      point = turned * point + place;
    map.append (seen);
  }
  return map;
}

} // namespace generate
