#include "graph/landmarks/cloud_vertices.h"

#include "common/index_limit.h"
#include "common/large_pages.h"

#include <pcl/manifold/sample_set.h>

#include <algorithm>
#include <utility>

namespace pcl {
namespace manifold {

namespace {

Status
findInSpace (Eigen::MatrixXd points, const pcl::Indices& indices, double resolution, CloudGraph& cloud)
{
  SampleSet samples;
  const Status status = makeSampleSet (points, indices, Thinning (), resolution, samples);
  if (status != Status::OK)
    return status;
  points.resize (0, 0); // every copy counts where there are many points
  resizeLarge (cloud.points, samples.points.rows (), samples.points.cols ());
  cloud.points = samples.points;
  cloud.input_index = std::move (samples.input_index);
  cloud.vertex_of = std::move (samples.sample_of);
  cloud.non_finite = samples.non_finite;
  cloud.no_measurement = samples.no_measurement;
  cloud.duplicates = samples.duplicates;
  return Status::OK;
}

Status
findInAnyDimension (const Eigen::MatrixXd& points, const pcl::Indices& indices, CloudGraph& cloud)
{
  if (!fitsIndices (static_cast<std::uint64_t> (points.cols ())))
    return Status::TOO_MANY_POINTS;
  std::vector<pcl::index_t> order;
  for (Eigen::Index i = 0; i < points.cols (); ++i)
    if (points.col (i).allFinite ())
      order.push_back (static_cast<pcl::index_t> (i));
  if (order.empty ())
    return Status::NO_INPUT;
  cloud.non_finite = static_cast<std::size_t> (points.cols ()) - order.size ();
  std::sort (order.begin (), order.end (), [&points] (pcl::index_t a, pcl::index_t b) {
    for (Eigen::Index axis = 0; axis < points.rows (); ++axis)
      if (points (axis, a) != points (axis, b))
        return points (axis, a) < points (axis, b);
    return a < b;
  });
  cloud.vertex_of.assign (static_cast<std::size_t> (points.cols ()), -1);
  cloud.points.resize (points.rows (), static_cast<Eigen::Index> (order.size ()));
  Eigen::Index count = 0;
  for (const pcl::index_t i : order) {
    if (count == 0 || cloud.points.col (count - 1) != points.col (i)) {
      cloud.points.col (count++) = points.col (i);
      cloud.input_index.push_back (indices.empty () ? i : indices[static_cast<std::size_t> (i)]);
    }
    cloud.vertex_of[static_cast<std::size_t> (i)] = static_cast<pcl::index_t> (count - 1);
  }
  cloud.points.conservativeResize (Eigen::NoChange, count);
  cloud.duplicates = order.size () - static_cast<std::size_t> (count);
  return Status::OK;
}

} // namespace

Status
findVertices (Eigen::MatrixXd points, const pcl::Indices& indices, double resolution, CloudGraph& cloud)
{
  constexpr Eigen::Index SPACE = 3;
  if (points.rows () == SPACE)
    return findInSpace (std::move (points), indices, resolution, cloud);
  return findInAnyDimension (points, indices, cloud);
}

} // namespace manifold
} // namespace pcl
