#pragma once

#include <pcl/manifold/graph_voronoi.h>
#include <pcl/manifold/topology_report.h>

#include <array>
#include <cstddef>
#include <vector>

namespace pcl {
namespace manifold {

/** \brief How the faces of the landmark mesh are found.
 * \ingroup manifold */
enum class FaceRule
{
  SHORTEST_CYCLES, ///< as published: cycles by length, every edge in at most two of them (section 3.1)
  ROTATION_SYSTEM  ///< of this library: the order in which tiles follow each other along each tile's border
};

/** \brief The mesh on the landmarks. Numbers are positions in the list of landmarks.
 * \ingroup manifold */
struct LandmarkMesh
{
  /// Two numbers of landmarks.
  using Edge = std::array<pcl::index_t, 2>;

  /// Edges of the mesh in ascending order, the smaller end first: the adjacent pairs of tiles. The rotation
  /// system leaves out those that it found to cross others, and adds tiles that touch too little to be
  /// adjacent where it takes that to cut a face that is too long.
  std::vector<Edge> edges;

  /// Faces as closed walks along edges, without repetition of the first landmark, oriented consistently where
  /// that is possible.
  std::vector<std::vector<pcl::index_t>> faces;

  /// Loops of the boundary of the surface, likewise, as a face in their place would be; SHORTEST_CYCLES
  /// notices none. Every edge in them is in one face, or in none where it alone is between two holes.
  std::vector<std::vector<pcl::index_t>> holes;
};

/** \brief Finds the faces of the mesh of adjacent tiles (section 3.1, "Face enumeration").
 *
 * SHORTEST_CYCLES looks for no cycle of more than 32 edges.
 * \param[in] graph proper
 * \param[in] tiles of graphVoronoiDiagram
 * \param[in] landmarks the number of landmarks
 * \param[in] contacts of tileContacts
 * \param[in] rule how
 * \param[in] maximum_length of a face, in edges, 3 or more: a longer cycle is the boundary of a hole
 * \param[in] threads 0 = all cores; the result is the same for any number
 * \return edges, faces and holes
 * \ingroup manifold */
PCL_MANIFOLD_CORE_EXPORTS LandmarkMesh findFaces (const NeighborhoodGraph& graph,
                                                  const std::vector<pcl::index_t>& tiles,
                                                  std::size_t landmarks,
                                                  const std::vector<TileContact>& contacts, FaceRule rule,
                                                  int maximum_length, unsigned int threads);

/** \brief Cuts faces of more than three edges into triangles, by diagonals that are no edges of the mesh yet
 * as far as there are any.
 *
 * The best of all ways to cut a face, up to 24 edges; longer ones are cut up into such first.
 * \param[in] mesh edges and faces
 * \param[in] points coordinates of the landmarks, d x landmarks, to prefer short diagonals; without columns
 * the diagonals are chosen by the graph alone
 * \return the triangles, oriented as the faces are
 * \ingroup manifold */
PCL_MANIFOLD_CORE_EXPORTS std::vector<std::array<pcl::index_t, 3>> triangulateFaces (
  const LandmarkMesh& mesh, const Eigen::Ref<const Eigen::MatrixXd>& points);

/** \brief The topology of a mesh of landmarks, before it is cut into triangles: its faces are the surface,
 * its edges in no face the curve. Landmarks without an edge are not in it. Of a closed orientable component
 * of the surface n - e + f = 2 - 2 g (section 4.3).
 * \param[in] mesh any; an edge of a face need not be among the edges
 * \return without a solid
 * \ingroup manifold */
PCL_MANIFOLD_CORE_EXPORTS pcl::TopologyReport analyze (const LandmarkMesh& mesh);

} // namespace manifold
} // namespace pcl
