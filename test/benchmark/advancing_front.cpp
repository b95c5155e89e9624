#include "advancing_front.h"

#include <CGAL/Advancing_front_surface_reconstruction.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <array>
#include <cstddef>
#include <iterator>

namespace benchmark {

std::vector<pcl::SimplicialComplex::Triangle>
advancingFront (const Eigen::Matrix3Xd& points)
{
  using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
  std::vector<Point> own;
  for (const auto& point : points.colwise ())
    own.emplace_back (point.x (), point.y (), point.z ());
  std::vector<std::array<std::size_t, 3>> found;
  CGAL::advancing_front_surface_reconstruction (own.begin (), own.end (), std::back_inserter (found));
  std::vector<pcl::SimplicialComplex::Triangle> triangles;
  for (const auto& triangle : found)
    triangles.push_back ({static_cast<pcl::index_t> (triangle[0]), static_cast<pcl::index_t> (triangle[1]),
                          static_cast<pcl::index_t> (triangle[2])});
  return triangles;
}

} // namespace benchmark
