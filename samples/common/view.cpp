#include "view.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace pcl::manifold::apps {
namespace {

using Vector = std::array<double, 3>;

double
dot (const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/** \brief Looks down by `elevation` from the direction `azimuth` (both in degrees). */
View
viewFrom (double azimuth, double elevation)
{
  const double degree = std::acos (-1.0) / 180;
  const double ca = std::cos (azimuth * degree), sa = std::sin (azimuth * degree);
  const double ce = std::cos (elevation * degree), se = std::sin (elevation * degree);
  View view;
  view.towards = {-ca * ce, -sa * ce, -se};
  view.right = {-sa, ca, 0};
  view.up = {-ca * se, -sa * se, ce};
  return view;
}

/** \brief Centres a view and sizes it so that all corners are within it. */
void
fit (View& view, const std::vector<Vector>& corners, double aspect)
{
  constexpr double infinity = std::numeric_limits<double>::infinity ();
  const std::array<Vector, 3> axes{view.right, view.up, view.towards};
  Vector low{infinity, infinity, infinity};
  Vector high{-infinity, -infinity, -infinity};
  for (const Vector& corner : corners)
    for (int axis = 0; axis < 3; ++axis) {
      const double value = dot (corner, axes[axis]);
      low[axis] = std::min (low[axis], value);
      high[axis] = std::max (high[axis], value);
    }
  view.centre = {0, 0, 0};
  for (int axis = 0; axis < 3; ++axis)
    for (int i = 0; i < 3; ++i)
      view.centre[i] += (low[axis] + high[axis]) / 2 * axes[axis][i];
  constexpr double margin = 1.06;
  view.half_height = margin * std::max ((high[1] - low[1]) / 2, (high[0] - low[0]) / 2 / aspect);
  if (!(view.half_height > 0))
    view.half_height = 1;
}

/** \brief Number of cells of a grid over the picture that hold a corner. */
std::size_t
coverage (const View& view, const std::vector<Vector>& corners, double aspect)
{
  constexpr int rows = 72;
  const int columns = std::max (1, static_cast<int> (rows * aspect));
  std::vector<bool> covered (static_cast<std::size_t> (rows) * columns, false);
  const auto cell = [] (double position, int cells) {
    return std::clamp (static_cast<int> ((position + 1) / 2 * cells), 0, cells - 1);
  };
  for (const Vector& corner : corners) {
    const Vector offset{corner[0] - view.centre[0], corner[1] - view.centre[1], corner[2] - view.centre[2]};
    const int column = cell (dot (offset, view.right) / (view.half_height * aspect), columns);
    const int row = cell (dot (offset, view.up) / view.half_height, rows);
    covered[static_cast<std::size_t> (row) * columns + column] = true;
  }
  return static_cast<std::size_t> (std::count (covered.begin (), covered.end (), true));
}

} // namespace

std::vector<std::array<double, 3>>
cornersOf (const std::vector<Panel>& panels)
{
  std::vector<Vector> corners;
  for (const Panel& panel : panels)
    for (const Layer& layer : panel.layers) {
      std::vector<bool> seen (layer.positions->size (), false);
      for (const std::int32_t corner : layer.corners) {
        const auto& position = layer.positions->at (static_cast<std::size_t> (corner));
        const bool finite = std::all_of (position.begin (), position.end (),
                                         [] (float value) { return std::isfinite (value); });
        if (finite && !seen[static_cast<std::size_t> (corner)])
          corners.push_back ({position[0], position[1], position[2]});
        seen[static_cast<std::size_t> (corner)] = true;
      }
    }
  return corners;
}

View
chooseView (const std::vector<std::array<double, 3>>& corners, double aspect)
{
  constexpr std::size_t enough = 20000; // corners to choose by; the last fit is by all of them
  std::vector<Vector> some;
  const std::size_t step = corners.size () / enough + 1;
  for (std::size_t i = 0; i < corners.size (); i += step)
    some.push_back (corners[i]);
  View best = viewFrom (-60, 30);
  if (corners.empty ())
    return best;
  std::size_t most = 0;
  for (const double elevation : {30, 45, 60})
    for (int azimuth = -60; azimuth < 300; azimuth += 30) {
      View view = viewFrom (azimuth, elevation);
      fit (view, some, aspect);
      const std::size_t covered = coverage (view, some, aspect);
      // Steeper views and turned ones must be worth it.
      if (covered > most + most / 20) {
        most = covered;
        best = view;
      }
    }
  fit (best, corners, aspect);
  return best;
}

} // namespace pcl::manifold::apps
