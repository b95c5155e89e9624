#include "bare_triangulation.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <chrono>
#include <vector>

namespace benchmark {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

template <typename Tag>
using Triangulation = CGAL::Delaunay_triangulation_3<
  Kernel, CGAL::Triangulation_data_structure_3<CGAL::Triangulation_vertex_base_3<Kernel>,
                                               CGAL::Delaunay_triangulation_cell_base_3<Kernel>, Tag>>;

double
secondsSince (std::chrono::steady_clock::time_point start)
{
  return std::chrono::duration<double> (std::chrono::steady_clock::now () - start).count ();
}

} // namespace

double
bareTriangulation (const Eigen::Matrix3Xd& points, bool parallel, std::size_t& cells)
{
  std::vector<Kernel::Point_3> input;
  input.reserve (static_cast<std::size_t> (points.cols ()));
  for (Eigen::Index i = 0; i < points.cols (); ++i)
    input.emplace_back (points (0, i), points (1, i), points (2, i));
  const Eigen::Vector3d low = points.rowwise ().minCoeff ();
  const Eigen::Vector3d high = points.rowwise ().maxCoeff ();
  const auto start = std::chrono::steady_clock::now ();
  double seconds = 0.0;
  if (parallel) {
    using T = Triangulation<CGAL::Parallel_tag>;
    T::Lock_data_structure locks (
      CGAL::Bbox_3 (low.x (), low.y (), low.z (), high.x (), high.y (), high.z ()), 50);
    T triangulation (input.begin (), input.end (), &locks);
    seconds = secondsSince (start);
    cells = triangulation.number_of_cells ();
  } else {
    Triangulation<CGAL::Sequential_tag> triangulation (input.begin (), input.end ());
    seconds = secondsSince (start);
    cells = triangulation.number_of_cells ();
  }
  return seconds;
}

} // namespace benchmark
