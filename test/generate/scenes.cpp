#include <generate/closed_surfaces.h>
#include <generate/curves.h>
#include <generate/sampling.h>
#include <generate/scenes.h>
#include <generate/solids.h>

#include <cmath>

namespace generate {

std::vector<Shape>
mixedSceneShapes ()
{
  using Eigen::Vector3d;
  return {moved (sphere (1.0), Vector3d (0.0, 0.0, 0.0)), moved (torus (1.0, 0.4), Vector3d (3.5, 0.0, 0.0)),
          moved (trefoil (0.75), Vector3d (0.0, 4.5, 0.0)), moved (ball (0.6), Vector3d (4.0, 4.0, 0.0))};
}

LabelledCloud
mixedScene (double spacing, std::uint64_t seed, const Tick& tick)
{
  const std::vector<Shape> shapes = mixedSceneShapes ();
  LabelledCloud cloud;
  std::uint32_t object = 0;
  for (const Shape& shape : shapes) {
    const auto part = [&] (double fraction) {
      if (tick)
        tick ((object + fraction) / static_cast<double> (shapes.size ()));
    };
    cloud.append (blueNoise (shape, spacing, seed + object, Strata::SAMPLED, part), object);
    ++object;
  }
  return cloud;
}

LabelledCloud
mixedSceneRandom (std::size_t sphere_points, std::uint64_t seed)
{
  const std::vector<Shape> shapes = mixedSceneShapes ();
  const double per_area = static_cast<double> (sphere_points) / shapes.front ().measure ();
  LabelledCloud cloud;
  std::uint32_t object = 0;
  for (const Shape& shape : shapes) {
    // A ball as dense as the sphere would hold five times its points.
    const double count = shape.dimension == 3 ? static_cast<double> (sphere_points)
                                              : shape.measure () * std::pow (per_area, 0.5 * shape.dimension);
    cloud.append (uniform (shape, static_cast<std::size_t> (std::lround (count)), seed + object), object);
    ++object;
  }
  return cloud;
}

} // namespace generate
