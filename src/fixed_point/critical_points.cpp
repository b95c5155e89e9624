#include "fixed_point/critical_points.h"

#include "common/parallel.h"
#include "delaunay/circumcenter.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl {
namespace manifold {

Poles
computePoles (const VoronoiCell& cell)
{
  Poles poles;
  poles.positive = computePole (cell);
  double farthest = 0.0;
  for (const std::int32_t vertex : cell) {
    const Eigen::Vector3d v = cell.vertex (vertex);
    if (!(v.dot (poles.positive.direction) < 0.0))
      continue;
    const double distance = cell.isInfinite (vertex) ? std::numeric_limits<double>::infinity () : v.norm ();
    if (distance > farthest) {
      farthest = distance;
      poles.negative.direction = v.normalized ();
    }
  }
  poles.negative.height = farthest;
  // Only rounding can hide every vertex on that side.
  if (farthest == 0.0)
    poles.negative = {-poles.positive.direction, std::numeric_limits<double>::infinity ()};
  return poles;
}

double
poleRatio (const Poles& poles, const Eigen::Vector3d& critical)
{
  const bool unbounded = std::isinf (poles.positive.height);
  const bool positive =
    !unbounded && critical.dot (poles.positive.direction) > critical.dot (poles.negative.direction);
  return critical.norm () / (positive ? poles.positive : poles.negative).height;
}

std::vector<std::uint8_t>
findMedial (const DelaunayComplex& complex, const std::vector<Facet>& anchored,
            const CriticalPointParameters& parameters)
{
  const Eigen::Matrix3Xd& points = complex.samples->points;
  std::vector<Poles> poles (static_cast<std::size_t> (points.cols ()));
  parallelFor (poles.size (), [&] (std::size_t i) {
    poles[i] = computePoles (VoronoiCell (complex, static_cast<std::int32_t> (i)));
  });
  std::vector<std::uint8_t> medial (anchored.size ());
  parallelFor (anchored.size (), [&] (std::size_t i) {
    const std::array<std::int32_t, 3> samples = facetOf (complex, anchored[i].cell, anchored[i].facet);
    const Eigen::Vector3d center =
      circumcenter (points.col (samples[0]), points.col (samples[1]), points.col (samples[2]));
    const auto votes = std::count_if (samples.begin (), samples.end (), [&] (std::int32_t v) {
      return poleRatio (poles[v], center - points.col (v)) > parameters.ratio;
    });
    medial[i] = votes >= parameters.votes ? 1 : 0;
  });
  return medial;
}

} // namespace manifold
} // namespace pcl
