#pragma once

#include <pcl/manifold/graph_voronoi.h>

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

/** \brief The topology of one component of a landmark mesh, n - e + f = 2 - 2 g (section 4.3).
 * \ingroup manifold */
struct LandmarkComponent
{
  std::size_t vertices = 0;            ///< n: landmarks
  std::size_t edges = 0;               ///< e
  std::size_t faces = 0;               ///< f
  std::size_t triangles = 0;           ///< faces of three edges
  std::size_t edges_in_no_face = 0;    ///< of curves, and where no face was found
  std::size_t edges_in_one_face = 0;   ///< of the boundary
  std::size_t edges_in_two_faces = 0;  ///< inside of the surface
  std::size_t edges_in_more_faces = 0; ///< where it is no manifold
  /// The holes of the mesh, and loops of edges in one face that are in none of them, from each to the next
  /// that bounds the same fan of faces
  std::size_t boundary_loops = 0;
  bool orientable = true; ///< neighbours can be made to agree in direction

  /** \brief Is every edge in two faces?
   * \return true if so, and if there is a face */
  bool isClosed () const { return faces > 0 && edges_in_two_faces == edges; }

  /** \brief The genus by equation 2, if the component is closed and orientable.
   * \return (2 - n + e - f) / 2; else only that number, to which every boundary loop adds a half, and an edge in
   * no face up to as much */
  double genus () const
  {
    return (2.0 - static_cast<double> (vertices) + static_cast<double> (edges) -
            static_cast<double> (faces)) /
           2.0;
  }
};

/** \brief The topology of a landmark mesh: the sum over all components, and each of them, the one with the
 * most landmarks first. The formula for the genus is one for each component: that of the total is right where
 * there is one only.
 * \ingroup manifold */
struct LandmarkMeshReport
{
  LandmarkComponent total;                   ///< the sum over all components
  std::vector<LandmarkComponent> components; ///< the one with the most landmarks first
};

/** \brief Counts, and sorts by components: landmarks that hang together through edges. Close to linear.
 * \param[in] mesh any; an edge of a face that is not among the edges counts as one
 * \param[in] landmarks the number of landmarks: all numbers in the mesh are below it
 * \return the counts
 * \ingroup manifold */
PCL_MANIFOLD_CORE_EXPORTS LandmarkMeshReport analyze (const LandmarkMesh& mesh, std::size_t landmarks);

} // namespace manifold
} // namespace pcl
