#pragma once

#include <pcl/manifold/simplicial_complex.h>

#include <Eigen/Core>

#include <vector>

namespace pcl::manifold::apps {

/** \brief Triangles in space: a reference to what must stay. */
struct TriangleMesh
{
  const Eigen::Matrix3Xd& points;
  const std::vector<pcl::SimplicialComplex::Triangle>& triangles; ///< indices are valid for the points
};

/** \brief The largest distance of some places, 3 x n, from a mesh of at least one triangle; 0 for none. */
double largestDistance (const Eigen::Matrix3Xd& places, const TriangleMesh& mesh);

/** \brief Places all over a mesh: the corners of its triangles, and of smaller ones into which those are cut.
 * \param[in] step edges of the smaller triangles are no longer, unless that took more than 64 parts an edge;
 * every edge is cut in two at least */
Eigen::Matrix3Xd placesOn (const TriangleMesh& mesh, double step);

/** \brief The mean length of the edges of a mesh, those of two triangles counted twice; 0 for no triangle. */
double meanEdge (const TriangleMesh& mesh);

} // namespace pcl::manifold::apps
