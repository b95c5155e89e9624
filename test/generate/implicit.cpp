#include <generate/implicit.h>
#include <generate/marching.h>

#include <algorithm>
#include <cmath>

namespace generate {

namespace {

/** Newton's method along the gradient. */
Eigen::Vector3d
ontoSurface (const Field& field, Eigen::Vector3d p)
{
  for (int i = 0; i < 20; ++i) {
    const FieldValue here = field (p);
    const Eigen::Vector3d step = here.value / here.gradient.squaredNorm () * here.gradient;
    p -= step;
    // The error squares with each step: after one of 1e-7 nothing is left to gain.
    if (step.squaredNorm () < 1e-14)
      break;
  }
  return p;
}

/** Newton's method again, with steps along the surface until what is left is along the normal. */
Nearest
nearestOnSurface (const Field& field, const Eigen::Vector3d& p)
{
  Eigen::Vector3d x = ontoSurface (field, p);
  Eigen::Vector3d normal = field (x).gradient.normalized ();
  for (int i = 0; i < 100; ++i) {
    const Eigen::Vector3d off = p - x;
    const Eigen::Vector3d along = off - off.dot (normal) * normal;
    if (along.squaredNorm () < 1e-24)
      break;
    x = ontoSurface (field, x + along);
    normal = field (x).gradient.normalized ();
  }
  return {x, normal, (x - p).norm ()};
}

/** Area of the surface above a triangle: that of 16 smaller triangles with their corners brought onto it. */
double
areaAbove (const Field& field, const MarchedTriangle& triangle)
{
  constexpr int PARTS = 4;
  const auto corner = [&] (int i, int j) {
    const Eigen::Vector3d flat = triangle[0] + static_cast<double> (i) / PARTS * (triangle[1] - triangle[0]) +
                                 static_cast<double> (j) / PARTS * (triangle[2] - triangle[0]);
    return ontoSurface (field, flat);
  };
  const auto area = [] (const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
    return 0.5 * (b - a).cross (c - a).norm ();
  };
  double sum = 0.0;
  for (int i = 0; i < PARTS; ++i)
    for (int j = 0; i + j < PARTS; ++j) {
      sum += area (corner (i, j), corner (i + 1, j), corner (i, j + 1));
      if (i + j + 1 < PARTS)
        sum += area (corner (i + 1, j), corner (i + 1, j + 1), corner (i, j + 1));
    }
  return sum;
}

constexpr double APART = 2.4; ///< between the centres of the tori
constexpr double BLEND = 0.3; ///< how far from both surfaces two tori melt together

double
firstCentre (int handles)
{
  return -0.5 * APART * (handles - 1);
}

/** Signed distance from a torus of radii 1 and 0.4 about the axis x = centre, y = 0, and its gradient. */
FieldValue
torusField (const Eigen::Vector3d& p, double centre)
{
  constexpr double SMALL_RADIUS = 0.4, TINY = 1e-12;
  const double x = p.x () - centre, y = p.y ();
  const double ring = std::max (std::sqrt (x * x + y * y), TINY);
  const double off = std::max (std::sqrt ((ring - 1.0) * (ring - 1.0) + p.z () * p.z ()), TINY);
  const double outwards = (ring - 1.0) / off;
  return {off - SMALL_RADIUS, {outwards * x / ring, outwards * y / ring, p.z () / off}};
}

} // namespace

Shape
implicitSurface (const std::string& name, const Topology& topology, const Field& field,
                 const Eigen::AlignedBox3d& bounds, int cells)
{
  std::vector<MarchedTriangle> triangles =
    marchTetrahedra ([&field] (const Eigen::Vector3d& p) { return field (p).value; }, bounds, cells);
  Shape shape;
  shape.name = name;
  shape.dimension = 2;
  shape.topology = topology;
  for (MarchedTriangle& triangle : triangles) {
    for (Eigen::Vector3d& corner : triangle)
      corner = ontoSurface (field, corner);
    const double area = areaAbove (field, triangle);
    shape.patches.push_back ({area, 2.0 * area});
  }
  shape.extent = [triangles] (std::size_t patch, const Eigen::Vector3d&, const Eigen::Vector3d& size) {
    const MarchedTriangle& triangle = triangles[patch];
    const double side = std::max ((triangle[1] - triangle[0]).norm (), (triangle[2] - triangle[0]).norm ());
    const double across = (triangle[2] - triangle[1]).norm ();
    // The square is folded into the triangle: u from the first corner away, v along the far side. The margin
    // is for directions that are not orthogonal (a root of two) and for the way onto the surface.
    return Eigen::Vector3d (1.5 * side * size[0], 1.5 * across * size[1], 0.0);
  };
  shape.point = [field, triangles] (std::size_t patch, const Eigen::Vector3d& u) {
    const MarchedTriangle& t = triangles[patch];
    return ontoSurface (field, t[0] + u[0] * ((t[1] - t[0]) + u[1] * (t[2] - t[1])));
  };
  shape.density = [patches = shape.patches] (std::size_t patch, const Eigen::Vector3d& u) {
    return 2.0 * patches[patch].measure * u[0];
  };
  shape.nearest = [field] (const Eigen::Vector3d& p) { return nearestOnSurface (field, p); };
  return shape;
}

Field
chainedToriField (int handles)
{
  const double first = firstCentre (handles);
  // The smooth minimum of the distances, -b log (sum exp (-d_i / b)), taken relative to the smallest so far.
  return [=] (const Eigen::Vector3d& p) {
    FieldValue smallest = torusField (p, first);
    double sum = 1.0;
    for (int i = 1; i < handles; ++i) {
      const FieldValue torus = torusField (p, first + APART * i);
      const double off = (torus.value - smallest.value) / BLEND;
      const double weight = std::exp (-std::abs (off));
      if (off < 0.0) {
        sum = 1.0 + weight * sum;
        smallest = {torus.value, torus.gradient + weight * smallest.gradient};
      } else {
        sum += weight;
        smallest.gradient += weight * torus.gradient;
      }
    }
    return FieldValue{smallest.value - BLEND * std::log (sum), smallest.gradient / sum};
  };
}

Shape
chainedTori (int handles)
{
  const Eigen::Vector3d corner (1.7 - firstCentre (handles), 1.7, 0.7);
  Shape shape = implicitSurface ("genus" + std::to_string (handles), {2 - 2 * handles, 0},
                                 chainedToriField (handles), {-corner, corner});
  // Found by comparing all pairs of points and normals of a dense sample: 0.399, the bend of the tubes.
  shape.feature_size = 0.39;
  return shape;
}

Shape
genus2 ()
{
  return chainedTori (2);
}

Shape
genus3 ()
{
  return chainedTori (3);
}

} // namespace generate
