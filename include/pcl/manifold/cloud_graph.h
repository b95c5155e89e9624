#pragma once

#include <pcl/manifold/export.h>
#include <pcl/manifold/neighborhood_graph.h>
#include <pcl/manifold/stage_log.h>
#include <pcl/manifold/status.h>
#include <pcl/types.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace pcl {
namespace manifold {

/** \brief The neighbourhood graph of a cloud. Its vertices are the distinct finite points, in an order that
 * depends on their coordinates only, so that nothing computed from the graph depends on the order of the
 * cloud.
 * \ingroup manifold */
struct CloudGraph
{
  NeighborhoodGraph graph; ///< proper
  Eigen::MatrixXd points;  ///< per vertex its coordinates, d x n, shifted and scaled; or without columns

  /// Per vertex the index of its point in the user's cloud: the first of its exact duplicates.
  pcl::Indices input_index;
  /// Per entry of the user's indices its vertex; -1 for points that are not finite or no
  /// measurement.
  std::vector<pcl::index_t> vertex_of;

  std::size_t non_finite = 0;     ///< points dropped because a coordinate is NaN or infinite
  std::size_t no_measurement = 0; ///< points dropped because they stand for none, see SampleSet
  std::size_t duplicates = 0;     ///< points merged with an equal one
};

/** \brief A search of the user's own, as functions. Neither is called by two threads at a time.
 * \ingroup manifold */
struct NeighborSearch
{
  /// Told once which points of the cloud will be asked for, and are wanted as answers.
  std::function<void (const pcl::Indices& points)> prepare;
  /// The points nearest to one point, itself among them, in any order; what is not among the points that
  /// prepare () named is passed over. Answers how many there are; fewer than asked for if there are no more.
  std::function<int (pcl::index_t point, int count, pcl::Indices& found)> nearest;
};

/** \brief Makes the neighbourhood graph of a cloud, step 1 of the algorithm.
 * \param[in] points coordinates of the points that the indices name, d x n; three-dimensional ones are sorted
 * along a space-filling curve, others by their coordinates
 * \param[in] indices of the points in the user's cloud, or empty for 0 .. n-1
 * \param[in] resolution relative precision of the coordinates, looked at in three dimensions
 * \param[in] k neighbours of each point, at least 1; all others if there are no more than k
 * \param[in] search instead of this library's own, or with empty functions
 * \param[in] threads 0 = all cores; the result is the same for any number
 * \param[in,out] log of the stages "points" and "neighbourhood graph"
 * \param[out] result empty unless the answer is Status::OK
 * \return as makeSampleSet, PARAMETER_OUT_OF_RANGE for k < 1, and TOO_FEW_POINTS for fewer than three
 * distinct points. Does not throw.
 * \ingroup manifold */
PCL_MANIFOLD_CORE_EXPORTS Status makeCloudGraph (Eigen::MatrixXd points, const pcl::Indices& indices,
                                                 double resolution, int k, const NeighborSearch& search,
                                                 unsigned int threads, StageLog& log,
                                                 CloudGraph& result) noexcept;

/** \brief Takes over a graph that the user gives, mended by symmetrize (). Vertex i is the point that the
 * i-th index names.
 * \param[in] given any graph
 * \param[in] indices of the vertices in the user's cloud, or empty for 0 .. n-1
 * \param[in] threads, log as above, of the stage "neighbourhood graph"
 * \param[out] result without coordinates; empty unless the answer is Status::OK
 * \return as symmetrize (), PARAMETER_OUT_OF_RANGE if there are indices and not as many as vertices, and
 * TOO_FEW_POINTS for fewer than three vertices. Does not throw.
 * \ingroup manifold */
PCL_MANIFOLD_CORE_EXPORTS Status takeGraph (const NeighborhoodGraph& given, const pcl::Indices& indices,
                                            unsigned int threads, StageLog& log, CloudGraph& result) noexcept;

} // namespace manifold
} // namespace pcl
