#include <generate/lidar.h>
#include <generate/random.h>
#include <generate/village.h>

#include <boost/math/constants/constants.hpp>

#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace generate {

namespace {

using boost::math::constants::degree;
using boost::math::constants::two_pi;

void
check (const LidarSettings& settings)
{
  if (settings.points == 0)
    throw std::invalid_argument ("a lidar sweep needs at least one point");
  if (!(settings.range_noise >= 0.0))
    throw std::invalid_argument ("the noise of a lidar sweep must be 0 or more");
}

/** Sends pulses and notes what comes back from inside of the village. */
class Scanner
{
public:
  Scanner (const RayScene& scene, const LidarSettings& settings, int returns, double reach)
    : scene_ (scene), random_ (settings.seed + 1), noise_ (settings.range_noise), returns_ (returns),
      reach_ (reach)
  {}

  /** The directions of real pulses are not quite on their raster. */
  double jitter (double step) { return 0.5 * step * (random_.uniform () - 0.5); }

  void pulse (const Ray& ray)
  {
    constexpr double APART = 0.4, PASSES_LEAF = 0.6;
    double from = 1.0;
    for (int i = 0; i < returns_; ++i) {
      const auto hit = scene_.cast (ray, from, reach_);
      if (!hit)
        return;
      const Eigen::Vector3d place = ray.origin + hit->range * ray.direction;
      if (std::abs (place.x ()) > VILLAGE_HALF_LENGTH || std::abs (place.y ()) > VILLAGE_HALF_WIDTH)
        return;
      cloud.add (place + noise_ * random_.normal () * ray.direction, hit->truth.label, 0.0, false,
                 hit->truth.object);
      const bool is_leaf = hit->truth.label == 3;
      if (!hit->partial || (is_leaf && random_.uniform () > PASSES_LEAF))
        return;
      from = hit->range + APART;
      // What is nearer behind the first thing than that does not make a return of its own.
      const Eigen::Vector3d next = ray.origin + from * ray.direction;
      if (next.z () < villageGround (next.x (), next.y ()))
        return;
    }
  }

  LabelledCloud cloud;

private:
  const RayScene& scene_;
  Random random_;
  double noise_;
  int returns_;
  double reach_;
};

} // namespace

LabelledCloud
lidarAerial (const LidarSettings& settings, const Tick& tick)
{
  check (settings);
  constexpr double BEAM_RADIUS = 0.12, ALTITUDE = 100.0, HALF_SWATH = 30.0, STRIP = 12.0;
  constexpr double RETURNS_PER_PULSE = 1.02; // as found for this scene
  const double pulse_area = 2.0 * (2.0 * VILLAGE_HALF_LENGTH) * (2.0 * HALF_SWATH) * RETURNS_PER_PULSE;
  const double spacing = std::sqrt (pulse_area / static_cast<double> (settings.points));
  const RayScene scene = village (BEAM_RADIUS, settings.seed);
  Scanner scanner (scene, settings, 4, 2.0 * ALTITUDE);

  const double reach_angle = std::atan (HALF_SWATH / ALTITUDE),
               step = 2.0 * reach_angle * spacing / (2.0 * HALF_SWATH);
  for (const double side : {-1.0, 1.0}) {
    const double tilt = side * 10.0 * degree<double> ();
    const double ahead = ALTITUDE * std::tan (tilt);
    for (double along = 0.0; along < 2.0 * VILLAGE_HALF_LENGTH; along += spacing) {
      if (tick)
        tick ((side < 0.0 ? 0.0 : 0.5) + 0.25 * along / VILLAGE_HALF_LENGTH);
      const double x = along - VILLAGE_HALF_LENGTH - ahead;
      for (double angle = -reach_angle; angle < reach_angle; angle += step) {
        const double across = angle + scanner.jitter (step);
        const Eigen::Vector3d direction (std::tan (tilt), std::tan (across), -1.0);
        scanner.pulse ({{x + scanner.jitter (spacing), side * STRIP, ALTITUDE}, direction.normalized ()});
      }
    }
  }
  return std::move (scanner.cloud);
}

LabelledCloud
lidarTerrestrial (const LidarSettings& settings, const Tick& tick)
{
  check (settings);
  constexpr double BEAM_RADIUS = 0.02, EYE = 1.8, REACH = 90.0;
  constexpr double RETURNS_PER_PULSE = 0.5; // as found for this scene
  const double lowest = -50.0 * degree<double> (), highest = 60.0 * degree<double> ();
  const double angles = 2.0 * two_pi<double> () * (highest - lowest) * RETURNS_PER_PULSE;
  const double step = std::sqrt (angles / static_cast<double> (settings.points));
  const RayScene scene = village (BEAM_RADIUS, settings.seed);
  Scanner scanner (scene, settings, 1, REACH);

  const std::array<Eigen::Vector2d, 2> stations = {Eigen::Vector2d (-28.0, -3.0),
                                                   Eigen::Vector2d (4.0, -4.0)};
  for (std::size_t i = 0; i < stations.size (); ++i) {
    const Eigen::Vector2d& station = stations[i];
    const double height = villageGround (station.x (), station.y ()) + EYE;
    for (double azimuth = 0.0; azimuth < two_pi<double> (); azimuth += step) {
      if (tick)
        tick (0.5 * (static_cast<double> (i) + azimuth / two_pi<double> ()));
      for (double elevation = lowest; elevation < highest; elevation += step) {
        const double up = elevation + scanner.jitter (step), turn = azimuth + scanner.jitter (step);
        const Eigen::Vector3d direction (std::cos (up) * std::cos (turn), std::cos (up) * std::sin (turn),
                                         std::sin (up));
        scanner.pulse ({{station.x (), station.y (), height}, direction});
      }
    }
  }
  return std::move (scanner.cloud);
}

} // namespace generate
