#pragma once

#include <generate/labelled_cloud.h>
#include <generate/shape.h>

#include <pcl/manifold/reconstruct_shape.h>
#include <pcl/manifold/topology_report.h>

#include <Eigen/Core>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

/** What the tests of whole reconstructions and the command evaluate_models share. */
namespace must_show {

/** \brief The points of a generated cloud, rounded as those of a pcl::PointXYZ are. */
inline Eigen::Matrix3Xd
pointsOf (const generate::LabelledCloud& cloud)
{
  Eigen::Matrix3Xd points (3, static_cast<Eigen::Index> (cloud.size ()));
  for (std::size_t i = 0; i < cloud.size (); ++i)
    points.col (static_cast<Eigen::Index> (i)) = cloud.points[i].cast<float> ().cast<double> ();
  return points;
}

/** \brief What a reconstruction of a surface has to be; what is not given may be anything. */
struct Expected
{
  std::optional<std::int64_t> euler;
  std::optional<std::size_t> loops;
  std::optional<std::size_t> most_loops;
  std::optional<bool> orientable;
  double used = 0.0;      ///< at least this share of the samples
  bool manifold = true;   ///< no non-manifold edge or vertex
  bool one_piece = false; ///< one component
};

/** \brief What is asked of every sample of a shape: its topology. */
inline Expected
expectedOf (const generate::Shape& shape, double used)
{
  Expected expected;
  expected.euler = shape.topology.euler;
  expected.loops = static_cast<std::size_t> (shape.topology.boundary_components);
  expected.orientable = shape.topology.orientable;
  expected.used = used;
  expected.one_piece = true;
  return expected;
}

/** \brief What is asked of a watertight surface: closed, manifold, and so with two sides. */
inline Expected
closed (std::optional<std::int64_t> euler, double used)
{
  Expected expected;
  expected.euler = euler;
  expected.loops = 0;
  expected.orientable = true;
  expected.used = used;
  return expected;
}

/** \brief A reconstruction and its measures. */
struct Evaluation
{
  pcl::manifold::Status status = pcl::manifold::Status::NOT_COMPUTED;
  std::shared_ptr<const pcl::manifold::SampleDimensions> dimensions;
  pcl::SimplicialComplex shape;
  pcl::TopologyReport topology;
  double seconds = 0.0;
  std::size_t samples = 0;

  /** \brief The share of the samples that have a triangle. */
  double used () const
  {
    return samples == 0 ? 0.0
                        : static_cast<double> (topology.surface.vertices) / static_cast<double> (samples);
  }

  /** \brief What does not keep to the expectation, in words; empty if all does. */
  std::string complaints (const Expected& expected) const;
};

inline std::string
Evaluation::complaints (const Expected& expected) const
{
  if (status != pcl::manifold::Status::OK)
    return pcl::manifold::toString (status);
  const pcl::manifold::SurfaceTopology& surface = topology.surface;
  std::string text;
  const auto check = [&text] (bool good, const std::string& complaint) {
    if (!good)
      text += (text.empty () ? "" : ", ") + complaint;
  };
  if (expected.manifold)
    check (surface.isManifold (), std::to_string (surface.non_manifold_edges) + " non-manifold edges, " +
                                    std::to_string (surface.non_manifold_vertices) + " vertices");
  if (expected.euler)
    check (surface.euler_characteristic == *expected.euler, "Euler characteristic " +
                                                              std::to_string (surface.euler_characteristic) +
                                                              " is not " + std::to_string (*expected.euler));
  if (expected.loops)
    check (surface.boundary_loops == *expected.loops, std::to_string (surface.boundary_loops) +
                                                        " boundary loops, not " +
                                                        std::to_string (*expected.loops));
  if (expected.most_loops)
    check (surface.boundary_loops <= *expected.most_loops, std::to_string (surface.boundary_loops) +
                                                             " boundary loops, more than " +
                                                             std::to_string (*expected.most_loops));
  if (expected.orientable)
    check (surface.isOrientable () == *expected.orientable,
           *expected.orientable ? "not orientable" : "orientable");
  if (expected.one_piece)
    check (surface.components.size () == 1, std::to_string (surface.components.size ()) + " components");
  check (used () >= expected.used,
         std::to_string (samples - surface.vertices) + " samples without a triangle");
  return text;
}

/** \brief Reconstructs a cloud.
 * \param[in] dimensions of an earlier reconstruction of the same cloud, or null
 * \param[in] threads 0 = all */
inline Evaluation
reconstruct (const Eigen::Matrix3Xd& points, bool watertight,
             const std::shared_ptr<const pcl::manifold::SampleDimensions>& dimensions = nullptr,
             unsigned int threads = 0)
{
  pcl::manifold::ShapeParameters parameters;
  parameters.watertight = watertight;
  parameters.dimension.threads = threads;
  parameters.dimension.dimensions = dimensions;
  pcl::manifold::StageLog log;
  Evaluation result;
  const auto start = std::chrono::steady_clock::now ();
  result.status = pcl::manifold::reconstructShape (points, {}, pcl::manifold::FLOAT_RESOLUTION, parameters,
                                                   log, result.dimensions, result.shape);
  result.seconds = std::chrono::duration<double> (std::chrono::steady_clock::now () - start).count ();
  if (result.status == pcl::manifold::Status::OK)
    result.samples = static_cast<std::size_t> (result.dimensions->complex->samples->size ());
  result.topology = pcl::manifold::analyze (result.shape);
  return result;
}

} // namespace must_show
