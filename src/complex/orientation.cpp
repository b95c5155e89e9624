#include "complex/consistent_triangles.h"
#include "complex/surface_patches.h"

#include <pcl/manifold/simplicial_complex.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl {
namespace manifold {

namespace {

using Triangle = SimplicialComplex::Triangle;
using Points = Eigen::Ref<const Eigen::Matrix3Xd>;

/** \brief Six times the volume of the cone over each patch from its middle, negative for one that faces
 * inward. From there it tells of open patches, too, which way they are bent; and far from the origin the
 * differences of large volumes would drown it. */
class EnclosedVolumes
{
public:
  EnclosedVolumes (std::size_t patches, const Points& points)
    : points_ (points), volumes_ (patches, 0.0), sizes_ (patches, 0.0),
      middles_ (Eigen::Matrix3Xd::Zero (3, static_cast<Eigen::Index> (patches))), corners_ (patches, 0.0)
  {}

  /** \brief To be called for all triangles first. */
  void addToMiddle (const Triangle& t, std::uint32_t patch)
  {
    for (const pcl::index_t vertex : t) {
      corners_[patch] += 1.0;
      middles_.col (patch) += (points_.col (vertex) - middles_.col (patch)) / corners_[patch];
    }
  }

  void add (const Triangle& t, std::uint32_t patch, bool turned)
  {
    const Eigen::Vector3d a = points_.col (t[0]) - middles_.col (patch);
    const Eigen::Vector3d b = points_.col (t[1]) - middles_.col (patch);
    const Eigen::Vector3d c = points_.col (t[2]) - middles_.col (patch);
    const double volume = a.dot (b.cross (c));
    volumes_[patch] += turned ? -volume : volume;
    sizes_[patch] += std::abs (volume);
  }

  bool isInward (std::uint32_t patch, bool open) const
  {
    return volumes_[patch] < (open ? -LEAST_BEND * sizes_[patch] : 0.0);
  }

private:
  // An open patch with as much on one side of its middle as on the other, but for this share, has no inside.
  static constexpr double LEAST_BEND = 0.1;

  const Points& points_;
  std::vector<double> volumes_;
  std::vector<double> sizes_; ///< the same without signs
  Eigen::Matrix3Xd middles_;
  std::vector<double> corners_;
};

// Neighbours agree: only patches that face inward are to be turned.
Orientation
orientConsistent (std::vector<Triangle>& triangles, const ConsistentPatches& patches, const Points& points)
{
  EnclosedVolumes volumes (patches.has_boundary.size (), points);
  for (std::size_t f = 0; f < triangles.size (); ++f)
    volumes.addToMiddle (triangles[f], patches.patch[f]);
  for (std::size_t f = 0; f < triangles.size (); ++f)
    volumes.add (triangles[f], patches.patch[f], false);
  for (std::size_t f = 0; f < triangles.size (); ++f)
    if (volumes.isInward (patches.patch[f], patches.has_boundary[patches.patch[f]] != 0))
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
      volumes.addToMiddle (triangles[sides.source[f]], patches.patch[f]);
    for (std::size_t f = 0; f < sides.faces (); ++f)
      volumes.add (triangles[sides.source[f]], patches.patch[f], patches.turned[f] != 0);
    for (std::uint32_t p = 0; p < inward.size (); ++p)
      inward[p] = patches.orientable[p] != 0 && volumes.isInward (p, patches.has_boundary[p] != 0);
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
