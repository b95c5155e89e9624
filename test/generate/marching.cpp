#include <generate/marching.h>

#include <cmath>
#include <utility>

namespace generate {

namespace {

struct GridCorner
{
  Eigen::Vector3d place;
  double value;
};

/** Where the surface cuts an edge. Always computed from the corner of negative value, so that all tetrahedra
 * at the edge agree. */
Eigen::Vector3d
cut (const GridCorner& inside, const GridCorner& outside)
{
  const double t = inside.value / (inside.value - outside.value);
  return inside.place + t * (outside.place - inside.place);
}

void
addTetrahedron (const std::array<const GridCorner*, 4>& corners, std::vector<MarchedTriangle>& triangles)
{
  std::vector<const GridCorner*> inside, outside;
  for (const GridCorner* corner : corners)
    (corner->value < 0.0 ? inside : outside).push_back (corner);
  if (inside.size () == 2) {
    const Eigen::Vector3d a = cut (*inside[0], *outside[0]), b = cut (*inside[0], *outside[1]);
    const Eigen::Vector3d c = cut (*inside[1], *outside[1]), d = cut (*inside[1], *outside[0]);
    triangles.push_back ({a, b, c});
    triangles.push_back ({a, c, d});
  } else if (inside.size () == 1) {
    triangles.push_back (
      {cut (*inside[0], *outside[0]), cut (*inside[0], *outside[1]), cut (*inside[0], *outside[2])});
  } else if (inside.size () == 3) {
    triangles.push_back (
      {cut (*inside[0], *outside[0]), cut (*inside[1], *outside[0]), cut (*inside[2], *outside[0])});
  }
}

} // namespace

std::vector<MarchedTriangle>
marchTetrahedra (const std::function<double (const Eigen::Vector3d&)>& value,
                 const Eigen::AlignedBox3d& bounds, int cells)
{
  const double size = bounds.sizes ().maxCoeff () / cells;
  const Eigen::Vector3i count = (bounds.sizes () / size).array ().ceil ().cast<int> ();
  std::vector<GridCorner> grid;
  for (int z = 0; z <= count.z (); ++z)
    for (int y = 0; y <= count.y (); ++y)
      for (int x = 0; x <= count.x (); ++x) {
        const Eigen::Vector3d place = bounds.min () + size * Eigen::Vector3d (x, y, z);
        grid.push_back ({place, value (place)});
      }
  const auto corner = [&] (int x, int y, int z) {
    return &grid[static_cast<std::size_t> ((z * (count.y () + 1) + y) * (count.x () + 1) + x)];
  };

  // The six ways from one corner of a cube to the opposite one along its edges, a tetrahedron each.
  static constexpr int ORDERS[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
  std::vector<MarchedTriangle> triangles;
  for (int z = 0; z < count.z (); ++z)
    for (int y = 0; y < count.y (); ++y)
      for (int x = 0; x < count.x (); ++x)
        for (const auto& order : ORDERS) {
          std::array<int, 3> at = {x, y, z};
          std::array<const GridCorner*, 4> corners = {corner (x, y, z), nullptr, nullptr, nullptr};
          for (std::size_t step = 0; step < 3; ++step) {
            ++at[static_cast<std::size_t> (order[step])];
            corners[step + 1] = corner (at[0], at[1], at[2]);
          }
          addTetrahedron (corners, triangles);
        }
  return triangles;
}

} // namespace generate
