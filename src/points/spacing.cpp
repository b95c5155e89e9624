#include "points/spacing.h"

#include "points/nearest_neighbors.h"

#include <algorithm>
#include <limits>

namespace pcl {
namespace manifold {

std::vector<NearestDistance>
nearestDistances (const Eigen::Matrix3Xd& points)
{
  constexpr Eigen::Index ENOUGH = 1000;
  std::vector<NearestDistance> distances;
  if (points.cols () < 2)
    return distances;
  const std::vector<pcl::index_t> nearest = kNearestNeighbors (points, 1);
  const Eigen::Index step = std::max<Eigen::Index> (1, points.cols () / ENOUGH);
  for (Eigen::Index i = 0; i < points.cols (); i += step)
    distances.push_back ({i, (points.col (i) - points.col (nearest[i])).norm ()});
  return distances;
}

double
medianSpacing (const Eigen::Matrix3Xd& points)
{
  std::vector<NearestDistance> distances = nearestDistances (points);
  if (distances.empty ())
    return std::numeric_limits<double>::infinity ();
  const auto middle = distances.begin () + static_cast<std::ptrdiff_t> (distances.size () / 2);
  std::nth_element (
    distances.begin (), middle, distances.end (),
    [] (const NearestDistance& a, const NearestDistance& b) { return a.distance < b.distance; });
  return middle->distance;
}

} // namespace manifold
} // namespace pcl
