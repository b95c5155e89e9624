#include "extraction/triangle_shape.h"

#include <Eigen/Geometry>

#include <limits>

namespace pcl {
namespace manifold {

double
squaredCircumradius (const DelaunayComplex& complex, std::int32_t cell, int facet)
{
  const std::array<std::int32_t, 3> triangle = facetOf (complex, cell, facet);
  const Eigen::Matrix3Xd& points = complex.samples->points;
  const Eigen::Vector3d u = points.col (triangle[1]) - points.col (triangle[0]);
  const Eigen::Vector3d v = points.col (triangle[2]) - points.col (triangle[0]);
  const double area = u.cross (v).squaredNorm ();
  if (!(area > 0.0))
    return std::numeric_limits<double>::infinity ();
  return u.squaredNorm () * v.squaredNorm () * (u - v).squaredNorm () / (4.0 * area);
}

double
dihedralCosine (const DelaunayComplex& complex, std::int32_t a, std::int32_t b, std::int32_t c,
                std::int32_t d)
{
  const Eigen::Matrix3Xd& points = complex.samples->points;
  const Eigen::Vector3d edge = (points.col (b) - points.col (a)).normalized ();
  const auto awayFromEdge = [&] (std::int32_t vertex) {
    const Eigen::Vector3d v = points.col (vertex) - points.col (a);
    return Eigen::Vector3d ((v - v.dot (edge) * edge).stableNormalized ());
  };
  return awayFromEdge (c).dot (awayFromEdge (d));
}

double
meanEdge (const FacetSet& surface, std::int32_t sample)
{
  const VoronoiCell cell (surface.complex (), sample);
  double sum = 0.0;
  int count = 0;
  surface.forEachAt (sample, [&] (std::int32_t a, int facet) {
    for (const std::int32_t vertex : oppositeSide (surface.complex (), a, facet, sample)) {
      sum += cell.relative (vertex).norm ();
      ++count;
    }
  });
  return count > 0 ? sum / count : 0.0;
}

} // namespace manifold
} // namespace pcl
