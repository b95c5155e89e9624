#include "complex/surface_patches.h"

#include <pcl/manifold/simplicial_complex.h>

#include <Eigen/Dense>

#include <algorithm>
#include <optional>
#include <utility>

namespace pcl {
namespace manifold {

namespace {

using Triangle = SimplicialComplex::Triangle;
using Points = Eigen::Ref<const Eigen::Matrix3Xd>;

/** \brief Six times the volume that each patch encloses, negative for one that faces inward. Measured from a
 * point of the patch, because far from the origin the differences of large volumes would drown it. */
std::vector<double>
enclosedVolumes (const std::vector<Triangle>& triangles, const SurfaceSides& sides,
                 const SurfacePatches& patches, const Points& points)
{
  std::vector<double> volumes (patches.orientable.size (), 0);
  std::vector<std::optional<Eigen::Vector3d>> apexes (volumes.size ());
  for (std::size_t f = 0; f < sides.faces (); ++f) {
    const Triangle& t = triangles[sides.source[f]];
    auto& apex = apexes[patches.patch[f]];
    if (!apex)
      apex = points.col (t[0]);
    const Eigen::Vector3d a = points.col (t[0]) - *apex;
    const Eigen::Vector3d b = points.col (t[1]) - *apex;
    const Eigen::Vector3d c = points.col (t[2]) - *apex;
    const double volume = a.dot (b.cross (c));
    volumes[patches.patch[f]] += patches.turned[f] != 0 ? -volume : volume;
  }
  return volumes;
}

Orientation
orient (std::vector<Triangle>& triangles, const Points* points)
{
  const SurfaceSides sides =
    points != nullptr ? SurfaceSides (toFaceRows (triangles), static_cast<std::size_t> (points->cols ()))
                      : SurfaceSides (toFaceRows (triangles));
  const SurfacePatches patches (sides);
  std::vector<std::uint8_t> inward (patches.orientable.size (), 0);
  if (points != nullptr) {
    const std::vector<double> volumes = enclosedVolumes (triangles, sides, patches, *points);
    for (std::size_t p = 0; p < volumes.size (); ++p)
      inward[p] = patches.orientable[p] != 0 && patches.has_boundary[p] == 0 && volumes[p] < 0;
  }
  for (std::size_t f = 0; f < sides.faces (); ++f) {
    Triangle& t = triangles[sides.source[f]];
    if (patches.turned[f] != inward[patches.patch[f]])
      std::swap (t[1], t[2]);
  }

  Orientation result;
  result.patches = patches.orientable.size ();
  result.non_orientable_patches =
    static_cast<std::size_t> (std::count (patches.orientable.begin (), patches.orientable.end (), 0));
  return result;
}

} // namespace

Orientation
orientTriangles (std::vector<Triangle>& triangles)
{
  return orient (triangles, nullptr);
}

Orientation
orientTriangles (std::vector<Triangle>& triangles, const Eigen::Ref<const Eigen::Matrix3Xd>& points)
{
  return orient (triangles, &points);
}

} // namespace manifold
} // namespace pcl
