#include <generate/random.h>
#include <generate/scene_parts.h>
#include <generate/street.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace generate {

namespace {

using Eigen::Vector3d;

constexpr double CAMBER = 0.08, KERB = 0.12, GARDEN_END = 45.0;
constexpr double SIDES[] = {-1.0, 1.0};

Vector3d
onGround (double x, double y)
{
  return {x, y, streetGround (y)};
}

/** Strips along the whole street, kerbs among them. */
void
addGround (RayScene& scene)
{
  const Truth road = truth (2, LidarClass::ROAD), garden = truth (2, LidarClass::GROUND);
  const auto addStrip = [&scene] (double y0, double z0, double y1, double z1, Truth what) {
    const double far = STREET_HALF_LENGTH;
    addQuad (scene, {-far, y0, z0}, {far, y0, z0}, {far, y1, z1}, {-far, y1, z1}, what);
  };
  const double gutter = -CAMBER, pavement = KERB - CAMBER;
  for (const double side : SIDES) {
    addStrip (0.0, 0.0, side * ROAD_HALF_WIDTH, gutter, road);
    addStrip (side * ROAD_HALF_WIDTH, gutter, side * ROAD_HALF_WIDTH, pavement, road);
    addStrip (side * ROAD_HALF_WIDTH, pavement, side * PAVEMENT_END, pavement, road);
    addStrip (side * PAVEMENT_END, pavement, side * GARDEN_END, pavement, garden);
  }
}

/** Posts with wires between them along the front of a garden. */
void
addFence (RayScene& scene, double from, double to, double y)
{
  constexpr double HEIGHT = 1.2, POST = 0.035, WIRE = 0.003, BETWEEN = 2.5;
  const Truth fence = truth (1, LidarClass::FENCE);
  const int fields = static_cast<int> ((to - from) / BETWEEN);
  for (int i = 0; i <= fields; ++i) {
    const Vector3d foot = onGround (from + BETWEEN * i, y);
    scene.addRod (foot, foot + HEIGHT * Vector3d::UnitZ (), POST, fence);
    if (i == fields)
      return;
    for (const double height : {0.3, 0.7, 1.1}) {
      const Vector3d at = foot + height * Vector3d::UnitZ ();
      scene.addRod (at, at + BETWEEN * Vector3d::UnitX (), WIRE, fence);
    }
  }
}

/** A row of houses on one side, some of them with a fence in front. */
void
addHouses (RayScene& scene, double side, Random& random)
{
  double x = -STREET_HALF_LENGTH + random.uniform (0.0, 6.0);
  while (x < STREET_HALF_LENGTH - 14.0) {
    const double length = random.uniform (9.0, 14.0), width = random.uniform (8.0, 10.0),
                 eaves = random.uniform (4.0, 7.0), front = random.uniform (9.0, 12.0);
    addHouse (scene, onGround (x + 0.5 * length, side * (front + 0.5 * width)), 0.0, length, width, eaves,
              eaves + 3.0);
    if (random.uniform () < 0.5)
      addFence (scene, x, x + length, side * (PAVEMENT_END + 0.2));
    x += length + random.uniform (2.5, 7.0);
  }
}

void
addBox (RayScene& scene, const Vector3d& low, const Vector3d& high, Truth what)
{
  const auto corner = [&] (int x, int y, int z) -> Vector3d {
    return {x == 0 ? low.x () : high.x (), y == 0 ? low.y () : high.y (), z == 0 ? low.z () : high.z ()};
  };
  for (const int end : {0, 1}) {
    addQuad (scene, corner (end, 0, 0), corner (end, 1, 0), corner (end, 1, 1), corner (end, 0, 1), what);
    addQuad (scene, corner (0, end, 0), corner (1, end, 0), corner (1, end, 1), corner (0, end, 1), what);
    addQuad (scene, corner (0, 0, end), corner (1, 0, end), corner (1, 1, end), corner (0, 1, end), what);
  }
}

/** Cars parked at the kerb. */
void
addCars (RayScene& scene, double side, Random& random)
{
  const Truth car = truth (2, LidarClass::CAR);
  for (double x = random.uniform (-100.0, -90.0); x < STREET_HALF_LENGTH - 10.0;
       x += random.uniform (6.0, 22.0)) {
    const Vector3d middle = onGround (x, side * (ROAD_HALF_WIDTH - 1.05));
    addBox (scene, middle + Vector3d (-2.1, -0.87, 0.25), middle + Vector3d (2.1, 0.87, 0.95), car);
    addBox (scene, middle + Vector3d (-1.3, -0.8, 0.95), middle + Vector3d (0.9, 0.8, 1.5), car);
  }
}

/** Lamp posts that reach over the road, and signs on thin poles that face along it. */
void
addPosts (RayScene& scene, double side, Random& random)
{
  const Truth pole = truth (1, LidarClass::POLE), sign = truth (2, LidarClass::SIGN);
  for (double x = -95.0 + 12.5 * side; x < 100.0; x += 25.0) {
    const Vector3d foot = onGround (x, side * 4.2), top = foot + 7.0 * Vector3d::UnitZ ();
    scene.addRod (foot, top, 0.075, pole);
    scene.addRod (top, top + Vector3d (0.0, -1.8 * side, 0.25), 0.045, pole);
  }
  for (double x = random.uniform (-100.0, -90.0); x < 100.0; x += random.uniform (12.0, 25.0)) {
    const Vector3d foot = onGround (x, side * 4.6);
    scene.addRod (foot, foot + 2.7 * Vector3d::UnitZ (), 0.035, pole);
    const double turn = random.uniform (-0.3, 0.3);
    const Vector3d plate = foot + Vector3d (0.05, 0.0, 2.35);
    const Vector3d across = 0.32 * Vector3d (std::sin (turn), std::cos (turn), 0.0),
                   up = 0.32 * Vector3d::UnitZ ();
    addQuad (scene, plate - across - up, plate + across - up, plate + across + up, plate - across + up, sign);
  }
}

/** Wooden poles behind one of the pavements, three cables between them, and one from each to the other side.
 */
void
addCables (RayScene& scene)
{
  constexpr double HEIGHT = 7.5, BETWEEN = 28.0, Y = -6.2, HOUSES = 11.0;
  const Truth pole = truth (1, LidarClass::POLE);
  for (double x = -100.0; x < STREET_HALF_LENGTH; x += BETWEEN) {
    const Vector3d foot = onGround (x, Y), top = foot + HEIGHT * Vector3d::UnitZ ();
    scene.addRod (foot, top, 0.11, pole);
    addWire (scene, top, Vector3d (x + 3.0, HOUSES, 5.5), 0.25);
    if (x + BETWEEN < STREET_HALF_LENGTH)
      for (const double below : {0.1, 0.6, 1.1}) {
        const Vector3d from = top - below * Vector3d::UnitZ ();
        addWire (scene, from, from + BETWEEN * Vector3d::UnitX (), 0.5);
      }
  }
}

void
addStreetTrees (RayScene& scene, double side, Random& random)
{
  const TreeSize size{{1.3, 1.3, 1.4}, {1.9, 1.9, 2.2}};
  for (double x = random.uniform (-100.0, -85.0); x < 100.0; x += random.uniform (14.0, 30.0))
    addTree (scene, onGround (x, side * 5.4), size, random);
}

} // namespace

double
streetGround (double y)
{
  const double off = std::abs (y);
  return off < ROAD_HALF_WIDTH ? -CAMBER * off / ROAD_HALF_WIDTH : KERB - CAMBER;
}

RayScene
street (double beam_radius, std::uint64_t seed)
{
  Random random (seed);
  RayScene scene (beam_radius);
  addGround (scene);
  for (const double side : SIDES) {
    addHouses (scene, side, random);
    addCars (scene, side, random);
    addPosts (scene, side, random);
    addStreetTrees (scene, side, random);
  }
  addCables (scene);
  scene.build ();
  return scene;
}

} // namespace generate
