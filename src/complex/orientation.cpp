#include "complex/consistent_triangles.h"
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
class EnclosedVolumes
{
public:
  EnclosedVolumes (std::size_t patches, const Points& points)
    : points_ (points), volumes_ (patches, 0.0), apexes_ (patches)
  {}

  void add (const Triangle& t, std::uint32_t patch, bool turned)
  {
    auto& apex = apexes_[patch];
    if (!apex)
      apex = points_.col (t[0]);
    const Eigen::Vector3d a = points_.col (t[0]) - *apex;
    const Eigen::Vector3d b = points_.col (t[1]) - *apex;
    const Eigen::Vector3d c = points_.col (t[2]) - *apex;
    const double volume = a.dot (b.cross (c));
    volumes_[patch] += turned ? -volume : volume;
  }

  bool isInward (std::uint32_t patch) const { return volumes_[patch] < 0; }

private:
  const Points& points_;
  std::vector<double> volumes_;
  std::vector<std::optional<Eigen::Vector3d>> apexes_;
};

// Neighbours agree: only closed patches that face inward are to be turned.
Orientation
orientConsistent (std::vector<Triangle>& triangles, const ConsistentPatches& patches, const Points& points)
{
  EnclosedVolumes volumes (patches.has_boundary.size (), points);
  for (std::size_t f = 0; f < triangles.size (); ++f)
    volumes.add (triangles[f], patches.patch[f], false);
  for (std::size_t f = 0; f < triangles.size (); ++f)
    if (patches.has_boundary[patches.patch[f]] == 0 && volumes.isInward (patches.patch[f]))
      std::swap (triangles[f][1], triangles[f][2]);
  Orientation result;
  result.patches = patches.has_boundary.size ();
  return result;
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
    EnclosedVolumes volumes (inward.size (), *points);
    for (std::size_t f = 0; f < sides.faces (); ++f)
      volumes.add (triangles[sides.source[f]], patches.patch[f], patches.turned[f] != 0);
    for (std::uint32_t p = 0; p < inward.size (); ++p)
      inward[p] = patches.orientable[p] != 0 && patches.has_boundary[p] == 0 && volumes.isInward (p);
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
  ConsistentPatches patches;
  if (findConsistentPatches (triangles, static_cast<std::size_t> (points.cols ()), patches))
    return orientConsistent (triangles, patches, points);
  return orient (triangles, &points);
}

} // namespace manifold
} // namespace pcl
