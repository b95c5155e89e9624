#pragma once

#include <pcl/manifold/simplicial_complex.h>

#include <Eigen/Core>

#include <array>
#include <memory>
#include <vector>

namespace pcl::manifold::apps {

/** \brief Triangles in space: a reference to what must stay. */
struct TriangleMesh
{
  const Eigen::Matrix3Xd& points;
  const std::vector<pcl::SimplicialComplex::Triangle>& triangles; ///< indices are valid for the points
};

/** \brief How far places are from a mesh. */
class MeshDistance
{
public:
  /** \param[in] mesh of at least one triangle; may be gone afterwards */
  explicit MeshDistance (const TriangleMesh& mesh);

  MeshDistance (const MeshDistance&) = delete;
  MeshDistance& operator= (const MeshDistance&) = delete;

  ~MeshDistance ();

  /** \brief The largest distance of some places, 3 x n, from the mesh; 0 for none. In parallel. */
  double largestOf (const Eigen::Matrix3Xd& places) const;

private:
  struct Search;
  std::unique_ptr<Search> search_;
};

/** \brief Places all over a mesh: the corners of its triangles, and of smaller ones into which those are cut.
 * \param[in] step edges of the smaller triangles are no longer, unless that took more than 64 parts an edge;
 * every edge is cut in two at least */
Eigen::Matrix3Xd placesOn (const TriangleMesh& mesh, double step);

/** \brief The mean length of the edges of a mesh, those of two triangles counted twice; 0 for no triangle. */
double meanEdge (const TriangleMesh& mesh);

} // namespace pcl::manifold::apps
