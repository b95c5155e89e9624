#pragma once

#include <pcl/manifold/export.h>
#include <pcl/manifold/status.h>
#include <pcl/types.h>

#include <Eigen/Core>

#include <cstddef>
#include <string>
#include <vector>

namespace pcl {
namespace manifold {

/** \brief An undirected graph whose vertices are points, in compressed rows: the neighbours of vertex v are
 * neighbors[offsets[v]] to neighbors[offsets[v + 1] - 1].
 *
 * In a proper graph, see isProper (), every row is in ascending order without repetition, no vertex is its
 * own neighbour, and every edge is in the rows of both of its ends.
 * \ingroup manifold */
struct NeighborhoodGraph
{
  std::vector<std::size_t> offsets;    ///< one more than vertices; {0} or nothing for the empty graph
  std::vector<pcl::index_t> neighbors; ///< the rows, one after the other

  /** \brief The number of vertices.
   * \return 0 for the empty graph */
  pcl::index_t size () const
  {
    return offsets.empty () ? 0 : static_cast<pcl::index_t> (offsets.size () - 1);
  }

  /** \brief The first neighbour of a vertex.
   * \param[in] vertex its number
   * \return where its row begins */
  const pcl::index_t* begin (pcl::index_t vertex) const { return neighbors.data () + offsets[vertex]; }

  /** \brief Behind the last neighbour of a vertex.
   * \param[in] vertex its number
   * \return where its row ends */
  const pcl::index_t* end (pcl::index_t vertex) const { return neighbors.data () + offsets[vertex + 1]; }
};

/** \brief Is a graph as NeighborhoodGraph describes it?
 * \param[in] graph any arrays
 *
 * Linear in the number of edges, times the logarithm of large degrees. Uses the cores that the calling thread
 * may use.
 * \param[out] why if given and the answer is no, one line about the first thing that is wrong
 * \return true if so
 * \ingroup manifold */
PCL_MANIFOLD_CORE_EXPORTS bool isProper (const NeighborhoodGraph& graph, std::string* why = nullptr);

/** \brief Makes a proper graph of rows in any order, with one-way edges, repetitions and self loops: every
 * edge is taken both ways and once.
 * \param[in] directed its offsets must ascend from 0 to the number of neighbours
 * \param[in] threads 0 = all cores; the result is the same for any number
 * \param[out] graph empty unless the answer is Status::OK
 * \return PARAMETER_OUT_OF_RANGE for offsets or neighbours out of range, NO_INPUT for no vertex. Does not
 * throw.
 * \ingroup manifold */
PCL_MANIFOLD_CORE_EXPORTS Status symmetrize (const NeighborhoodGraph& directed, unsigned int threads,
                                             NeighborhoodGraph& graph) noexcept;

/** \brief The graph of an edge from every point to each of its k nearest neighbours (section 3.1,
 * "Neighborhood graph"); of equally near ones those of smaller index.
 *
 * Searched in bulk in a kd-tree: fastest if points that follow each other are near each other, as those of a
 * SampleSet are.
 * \param[in] points d x n, distinct: with duplicates the graph may fall apart, and the time grows with the
 * square of their number
 * \param[in] k at least 1; a k of n or more stands for n - 1
 * \param[in] threads 0 = all cores; the result is the same for any number
 * \param[out] graph proper; empty unless the answer is Status::OK
 * \param[in] progress if there is one, asked now and then with the share that is done
 * \return PARAMETER_OUT_OF_RANGE for k < 1, NO_INPUT for no point, INPUT_OUT_OF_RANGE for coordinates that
 * are not finite or so large that squared distances are not, CANCELLED where progress answered false. Does
 * not throw.
 * \ingroup manifold */
PCL_MANIFOLD_CORE_EXPORTS Status nearestNeighborGraph (const Eigen::Ref<const Eigen::MatrixXd>& points, int k,
                                                       unsigned int threads, NeighborhoodGraph& graph,
                                                       const ProgressCallback& progress = {}) noexcept;

} // namespace manifold
} // namespace pcl
