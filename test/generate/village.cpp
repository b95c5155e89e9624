#include <generate/random.h>
#include <generate/scene_parts.h>
#include <generate/village.h>

#include <array>
#include <cmath>
#include <utility>

namespace generate {

namespace {

using Eigen::Vector3d;

Vector3d
onGround (double x, double y)
{
  return {x, y, villageGround (x, y)};
}

/** A line of wooden poles with a cross-arm and three wires. */
void
addPoleLine (RayScene& scene)
{
  constexpr double HEIGHT = 9.0, ARM = 1.2, SAG = 1.1;
  const Truth pole = truth (1, LidarClass::POLE);
  const std::array<double, 4> stations = {-54.0, -18.0, 18.0, 54.0};
  std::array<Vector3d, 4> tops;
  for (std::size_t i = 0; i < stations.size (); ++i) {
    const Vector3d foot = onGround (stations[i], -12.0 + 0.05 * stations[i]);
    tops[i] = foot + HEIGHT * Vector3d::UnitZ ();
    scene.addRod (foot, tops[i], 0.09, pole);
    scene.addRod (tops[i] - ARM * Vector3d::UnitY (), tops[i] + ARM * Vector3d::UnitY (), 0.05, pole);
  }
  for (std::size_t i = 0; i + 1 < stations.size (); ++i)
    for (const double side : {-ARM, 0.0, ARM}) {
      const Vector3d offset (0.0, side, side == 0.0 ? 0.3 : 0.15);
      addWire (scene, tops[i] + offset, tops[i + 1] + offset, SAG);
    }
}

/** Two pylons of thin struts, and six wires high above the ground between them. */
void
addPylons (RayScene& scene)
{
  constexpr double X = 44.0, Y = 36.0, HEIGHT = 22.0, BASE = 1.8, TOP = 0.4, STRUT = 0.08, SAG = 3.0;
  const Truth pole = truth (1, LidarClass::POLE);
  const std::array<double, 2> arm_heights = {16.0, 20.0};
  const std::array<std::pair<double, double>, 4> corners = {{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
  for (const double y : {-Y, Y}) {
    const auto corner = [&] (std::size_t i, double height) -> Vector3d {
      const double half = BASE + (TOP - BASE) * height / HEIGHT;
      return Vector3d (X + half * corners[i].first, y + half * corners[i].second,
                       villageGround (X, y) + height);
    };
    for (std::size_t i = 0; i < corners.size (); ++i) {
      const std::size_t next = (i + 1) % corners.size ();
      scene.addRod (corner (i, -0.5), corner (i, HEIGHT), STRUT, pole);
      for (double height = 0.0; height + 4.0 <= HEIGHT; height += 4.0)
        scene.addRod (corner (i, height), corner (next, height + 4.0), 0.5 * STRUT, pole);
    }
    for (const double height : arm_heights) {
      const Vector3d middle (X, y, villageGround (X, y) + height);
      scene.addRod (middle - 4.5 * Vector3d::UnitX (), middle + 4.5 * Vector3d::UnitX (), STRUT, pole);
    }
  }
  for (const double height : arm_heights)
    for (const double side : {-4.5, -2.5, 4.5})
      addWire (scene, {X + side, -Y, villageGround (X, -Y) + height - 0.5},
               {X + side, Y, villageGround (X, Y) + height - 0.5}, SAG);
}

void
addLampPosts (RayScene& scene)
{
  const Truth pole = truth (1, LidarClass::POLE);
  for (const double x : {-45.0, -25.0, -5.0, 15.0}) {
    const Vector3d foot = onGround (x, 2.0), top = foot + Vector3d (0.0, 0.0, 6.0);
    scene.addRod (foot, top, 0.06, pole);
    scene.addRod (top, top + Vector3d (0.0, -1.3, 0.2), 0.04, pole);
  }
}

/** Trees on the open ground: away from houses, posts, lines and the scanners in the street. */
void
addTrees (RayScene& scene, Random& random)
{
  constexpr int COUNT = 24;
  std::vector<Vector3d> feet;
  while (feet.size () < COUNT) {
    const double x = random.uniform (-54.0, 36.0), y = random.uniform (-34.0, 34.0);
    bool free = std::abs (y) > 7.0 && std::abs (y + 12.0 - 0.05 * x) > 5.0;
    free = free && std::hypot (x + 20.0, y - 17.0) > 13.0 && std::hypot (x - 12.0, y - 14.0) > 9.0;
    for (const Vector3d& foot : feet)
      free = free && std::hypot (x - foot.x (), y - foot.y ()) > 5.0;
    if (free)
      feet.push_back (onGround (x, y));
  }
  const TreeSize size{{2.0, 2.0, 2.2}, {3.6, 3.6, 4.0}};
  for (const Vector3d& foot : feet)
    addTree (scene, foot, size, random);
}

} // namespace

double
villageGround (double x, double y)
{
  return 0.8 * std::sin (0.07 * x + 0.5) + 0.6 * std::sin (0.09 * y - 0.03 * x) +
         0.15 * std::sin (0.31 * x + 0.27 * y);
}

RayScene
village (double beam_radius, std::uint64_t seed)
{
  constexpr double STEEPEST = 0.21; // the sum of the slopes of the three waves
  Random random (seed);
  RayScene scene (beam_radius);
  scene.setGround (villageGround, STEEPEST, truth (2, LidarClass::GROUND));
  addPoleLine (scene);
  addPylons (scene);
  addLampPosts (scene);
  addHouse (scene, onGround (-20.0, 17.0), 0.35, 15.0, 9.0, 5.0, 8.5);
  addHouse (scene, onGround (12.0, 14.0), -0.2, 8.0, 6.0, 3.0, 5.0);
  addTrees (scene, random);
  scene.build ();
  return scene;
}

} // namespace generate
