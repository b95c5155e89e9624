#pragma once

#include <pcl/manifold/graph_faces.h>

#include <array>
#include <cstdint>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace pcl {
namespace manifold {

/** Cuts faces of a mesh into triangles, the cheapest way, one face after the other: a diagonal that an
 * earlier face took is an edge to the later ones. */
class FaceCutter
{
public:
  using Triangle = std::array<pcl::index_t, 3>;
  using Walk = std::vector<pcl::index_t>;

  /** \param[in] points coordinates of the landmarks, which must outlive this object; without columns the
   * diagonals are chosen by the graph alone */
  FaceCutter (const LandmarkMesh& mesh, const Eigen::Ref<const Eigen::MatrixXd>& points);

  /** Whether a face can be cut by diagonals that are no edges yet. */
  bool canCut (const Walk& face);

  /** Appends the triangles of a face. */
  void cut (Walk face, std::vector<Triangle>& triangles);

private:
  void addEdge (pcl::index_t a, pcl::index_t b);
  double cost (pcl::index_t a, pcl::index_t b) const;
  void compareAll (const Walk& piece);
  void cutPiece (const Walk& piece, std::vector<Triangle>& triangles);

  const Eigen::Ref<const Eigen::MatrixXd> points_;
  std::unordered_set<std::uint64_t> edges_; ///< of the mesh and diagonals
  std::unordered_map<pcl::index_t, int> degrees_;
  std::vector<double> costs_; ///< per pair of positions in a piece
  std::vector<std::size_t> apex_;
  std::vector<std::pair<std::size_t, std::size_t>> parts_;
};

} // namespace manifold
} // namespace pcl
