#pragma once

#include <pcl/Vertices.h>
#include <pcl/manifold/export.h>
#include <pcl/manifold/graph_faces.h>
#include <pcl/manifold/stage_log.h>

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <vector>

namespace pcl {
namespace manifold {

/** \brief Parameters of GraphReconstruction, as its setters explain them.
 * \ingroup manifold */
struct GraphParameters
{
  int k_search = 15;           ///< neighbours of each point, at least 1
  int hops = 5;                ///< least distance of two landmarks, at least 1
  bool refine = true;          ///< landmarks nearer to each other on thin parts
  int adjacency_threshold = 7; ///< of tiles that touch, at least 0
  AdjacencyRule adjacency_rule = AdjacencyRule::BOUNDARY_POINTS; ///< what is compared with it
  FaceRule face_rule = FaceRule::ROTATION_SYSTEM;                ///< how faces are found
  int maximum_face_length = 8;                                   ///< in edges, at least 3
  bool triangulate = true;                                       ///< cut larger faces
  std::uint64_t seed = 1;                                        ///< chooses the landmarks
  unsigned int threads = 0;                                      ///< 0 = all cores
};

/** \brief What GraphReconstruction finds. Vertices are those of the neighbourhood graph.
 * \ingroup manifold */
struct GraphMesh
{
  std::vector<pcl::index_t> landmarks;                ///< vertices, ascending
  std::vector<pcl::index_t> tiles;                    ///< per vertex the number of its landmark
  std::vector<TileContact> contacts;                  ///< tiles that touch each other
  LandmarkMesh mesh;                                  ///< over numbers of landmarks
  std::vector<std::array<pcl::index_t, 3>> triangles; ///< of the faces, if asked for
  pcl::TopologyReport report;                         ///< of the mesh, before it was triangulated
};

/** \brief GraphReconstruction without PCL: everything after the neighbourhood graph, steps 2 to 5.
 * \param[in] graph proper, see isProper ()
 * \param[in] points coordinates of the vertices, d x n, which choose the diagonals of larger faces and, for
 * three finite ones, which side of the surface is outside; may be without columns
 * \param[in] parameters k_search is not read
 * \param[in,out] log of the stages "stable set", "graph Voronoi diagram", "adjacency", "faces" and
 * "triangulation"
 * \param[out] result everything for Status::OK, all but faces for DIMENSION_TOO_LOW, else empty
 * \return PARAMETER_OUT_OF_RANGE for hops < 1, a negative threshold, a maximum length < 3 or as many points
 * as not vertices; TOO_FEW_POINTS for fewer than three vertices; DIMENSION_TOO_LOW where no face was found.
 * Does not throw.
 * \ingroup manifold */
PCL_MANIFOLD_CORE_EXPORTS Status reconstructGraph (const NeighborhoodGraph& graph,
                                                   const Eigen::Ref<const Eigen::MatrixXd>& points,
                                                   const GraphParameters& parameters, StageLog& log,
                                                   GraphMesh& result) noexcept;

/** \brief The triangles of a mesh, or its faces where no triangles were asked for, as polygons.
 * \param[in] mesh of reconstructGraph ()
 * \param[in] input_index what the polygons are to index, per vertex of the neighbourhood graph
 * \return a polygon a triangle or face. Throws where memory runs out
 * \ingroup manifold */
PCL_MANIFOLD_CORE_EXPORTS std::vector<pcl::Vertices> polygonsOf (const GraphMesh& mesh,
                                                                 const pcl::Indices& input_index);

} // namespace manifold
} // namespace pcl
