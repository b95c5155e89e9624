#pragma once

#include <pcl/manifold/cloud_graph.h>
#include <pcl/manifold/computation.h>
#include <pcl/manifold/detail/mesh_base.h>
#include <pcl/manifold/graph_faces.h>
#include <pcl/manifold/graph_voronoi.h>
#include <pcl/manifold/neighborhood_graph.h>
#include <pcl/manifold/reconstruct_graph.h>
#include <pcl/manifold/status.h>
#include <pcl/point_representation.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace pcl {

/** \brief Reconstructs a surface over a subset of the points, the landmarks, from the neighbourhoods of the
 * points alone.
 *
 * The algorithm of D. Dumitriu, S. Funke, M. Kutz, N. Milosavljevic, "How much geometry it takes to
 * reconstruct a 2-manifold in R^3", section 2: (1) a graph of an edge from every point to its k nearest
 * neighbours; (2) landmarks, a maximal set of points that are pairwise no fewer than some hops apart in it;
 * (3) tiles, the points nearest to each landmark in hops; (4) landmarks whose tiles touch enough are
 * adjacent; (5) faces, short cycles of adjacent landmarks. Coordinates take part in step 1 only, and in which
 * diagonals cut larger faces into triangles.
 *
 * Two things are of this library: faces are found by a rotation system unless setFaceRule () asks for the
 * published rule, and landmarks are nearer to each other on thin parts and on small clouds unless
 * setRefine (false) asks for the same distance everywhere.
 *
 * A search that setSearchMethod () of PCL's base class is given finds the neighbours, one query after the
 * other, with the distances that it knows. It is given the cloud and the indices of the distinct finite
 * points. By default the points are sorted along a space-filling curve and searched in bulk, in parallel.
 *
 * The points should sample a surface evenly, as dense as the thinnest part asks: parts nearer to each other
 * than a few spacings grow together. Points that are not finite, rays without measurement (see SampleSet),
 * and all but one of exact duplicates, are left out. What comes out is consistently oriented where it is
 * orientable; in three dimensions outwards.
 *
 * On failure the output is empty and getStatus () says why: NO_INPUT, TOO_FEW_POINTS for fewer than three
 * distinct points, DIMENSION_TOO_LOW where no face was found (the points lie along a curve, or are so few
 * that fewer than three landmarks are left), PARAMETER_OUT_OF_RANGE, INPUT_TOO_COARSE, INPUT_OUT_OF_RANGE,
 * TOO_MANY_POINTS, CANCELLED, OUT_OF_MEMORY, INTERNAL_ERROR (also where the progress callback throws).
 *
 * Time is that of a k nearest neighbour search, O (n log n), and about half of it again; memory about 230
 * bytes a point. The result is the same, bit for bit, for any number of threads and, up to renumbering, for
 * any order of the points. Where a graph is given the numbers of its vertices decide instead.
 *
 * The class derives from pcl::MeshConstruction for PCL's own point types with x, y and z, and from its base
 * pcl::PCLSurfaceBase, with the same functions, for all others: those need no PCL_NO_PRECOMPILE.
 * \ingroup manifold */
template <typename PointT>
class GraphReconstruction : public manifold::Computation<manifold::MeshBase<PointT>>
{
public:
  /** \brief A shared pointer to an object of this class. */
  using Ptr = shared_ptr<GraphReconstruction<PointT>>;

  /** \brief A shared pointer to a constant object of this class. */
  using ConstPtr = shared_ptr<const GraphReconstruction<PointT>>;

  /** \brief A shared pointer to what makes vectors of points. */
  using PointRepresentationConstPtr = typename PointRepresentation<PointT>::ConstPtr;

  /** \brief Every parameter has its default. */
  GraphReconstruction ()
  {
    // The base class would index the cloud again.
    this->check_tree_ = false;
  }

  /** \brief The number of neighbours that each point is joined with (kappa in the paper).
   * \param[in] k at least 1; 15 by default, as in section 3. A k of n or more joins every point with all
   * others */
  void setKSearch (int k) { parameters_.k_search = k; }

  /** \brief The number of neighbours that each point is joined with.
   * \return see setKSearch () */
  int getKSearch () const { return parameters_.k_search; }

  /** \brief The least distance of two landmarks in hops (k in the paper): the larger, the coarser the mesh.
   * \param[in] hops at least 1, which makes every point a landmark; 5 by default, as in section 4.3. 3 to 12
   * are of use */
  void setHops (int hops) { parameters_.hops = hops; }

  /** \brief The least distance of two landmarks.
   * \return in hops, see setHops () */
  int getHops () const { return parameters_.hops; }

  /** \brief Whether there are more landmarks where those of a maximal k-hop stable set would be too few to
   * tell the topology: on thin tubes and handles, in narrow gaps and on small clouds, see refineLandmarks ().
   * Of this library.
   * \param[in] refine true by default; false for the same distance everywhere, as published
   */
  void setRefine (bool refine) { parameters_.refine = refine; }

  /** \brief Whether landmarks are nearer to each other on thin parts.
   * \return see setRefine () */
  bool getRefine () const { return parameters_.refine; }

  /** \brief Tiles that touch by more than this are adjacent (a in the paper): too small, and adjacencies
   * cross; too large, and faces grow.
   * \param[in] threshold at least 0; 7 by default, as in section 3 */
  void setAdjacencyThreshold (int threshold) { parameters_.adjacency_threshold = threshold; }

  /** \brief By more than what tiles have to touch to be adjacent.
   * \return see setAdjacencyThreshold () */
  int getAdjacencyThreshold () const { return parameters_.adjacency_threshold; }

  /** \brief What is compared with the threshold, see AdjacencyRule.
   * \param[in] rule BOUNDARY_POINTS by default, as in section 3.1 */
  void setAdjacencyRule (manifold::AdjacencyRule rule) { parameters_.adjacency_rule = rule; }

  /** \brief What is compared with the threshold.
   * \return see setAdjacencyRule () */
  manifold::AdjacencyRule getAdjacencyRule () const { return parameters_.adjacency_rule; }

  /** \brief How faces are found, see FaceRule.
   * \param[in] rule ROTATION_SYSTEM by default; SHORTEST_CYCLES as published in section 3.1 */
  void setFaceRule (manifold::FaceRule rule) { parameters_.face_rule = rule; }

  /** \brief How faces are found.
   * \return see setFaceRule () */
  manifold::FaceRule getFaceRule () const { return parameters_.face_rule; }

  /** \brief The largest number of edges of a face: a longer cycle bounds a hole of the surface.
   * \param[in] length at least 3; 8 by default */
  void setMaximumFaceLength (int length) { parameters_.maximum_face_length = length; }

  /** \brief The largest number of edges of a face.
   * \return see setMaximumFaceLength () */
  int getMaximumFaceLength () const { return parameters_.maximum_face_length; }

  /** \brief Whether faces of more than three edges are cut into triangles. Where none but edges of the mesh
   * can cut a face, on parts as thin as a landmark, such an edge has more than two triangles then; a face
   * that is not cut may pass a landmark twice there. setRefine () leaves few of these.
   * \param[in] triangulate true by default */
  void setTriangulate (bool triangulate) { parameters_.triangulate = triangulate; }

  /** \brief Whether larger faces are cut into triangles.
   * \return see setTriangulate () */
  bool getTriangulate () const { return parameters_.triangulate; }

  /** \brief Chooses between the many maximal sets of landmarks.
   * \param[in] seed any; 1 by default */
  void setSeed (std::uint64_t seed) { parameters_.seed = seed; }

  /** \brief What chooses between the sets of landmarks.
   * \return see setSeed () */
  std::uint64_t getSeed () const { return parameters_.seed; }

  /** \brief A graph to be used instead of that of the nearest neighbours; no coordinates are needed then.
   * Edges count both ways, once each, and self loops are left out; an index out of range is refused with
   * PARAMETER_OUT_OF_RANGE.
   *
   * With an input cloud, coordinates choose only how larger faces are cut, and are not looked at where one of
   * them is not finite: all vertices count. Vertex i is the i-th point of setIndices () (of the cloud if that
   * was not called), and a graph of another size is refused with PARAMETER_OUT_OF_RANGE. Without one, the
   * polygons and all getters index the vertices of the graph, and the mesh has no cloud.
   * \param[in] graph null (the default) to go back to nearest neighbours */
  void setNeighborhoodGraph (std::shared_ptr<const manifold::NeighborhoodGraph> graph)
  {
    given_graph_ = std::move (graph);
  }

  /** \brief Points of any dimension: distances are those of the vectors that this gives, instead of those of
   * x, y and z. For point types without x, y and z it is needed, unless there is a graph. The default
   * representation of such a type that leaves out all but its first three floats, as that of a histogram
   * does, is refused with PARAMETER_OUT_OF_RANGE.
   * \param[in] representation null (the default) for x, y and z */
  void setPointRepresentation (PointRepresentationConstPtr representation)
  {
    representation_ = std::move (representation);
  }

  /** \brief What makes vectors of the points.
   * \return null for x, y and z */
  PointRepresentationConstPtr getPointRepresentation () const { return representation_; }

  /** \brief Reconstructs a mesh: the faces as polygons over all points of the input cloud.
   * \param[out] output its cloud has all fields, the layout and the header of the input; empty on failure, see
   * getStatus () */
  void reconstruct (pcl::PolygonMesh& output) override;

  /** \brief As above, polygons only.
   * \param[out] polygons index the input cloud; empty on failure */
  void reconstruct (std::vector<pcl::Vertices>& polygons) override;

  // What the stages of the last reconstruct () gave. All of it is there for the status OK, all but faces for
  // DIMENSION_TOO_LOW, and nothing otherwise.

  /** \brief The landmarks.
   * \return indices into the input cloud */
  pcl::Indices getLandmarks () const;

  /** \brief The landmark of each point.
   * \return per point (of those that setIndices () names, in their order) a position in getLandmarks (); a
   * duplicate has that of the point that was kept, a point that is not finite or no measurement -1 */
  std::vector<pcl::index_t> getTiles () const;

  /** \brief Whose tiles touch, and whether that makes them adjacent.
   * \return pairs of landmarks, by their numbers */
  const std::vector<manifold::TileContact>& getAdjacency () const { return result_.contacts; }

  /** \brief The mesh of landmarks.
   * \return edges, faces and holes over the numbers of landmarks; the faces as found, not triangulated */
  const manifold::LandmarkMesh& getLandmarkMesh () const { return result_.mesh; }

  /** \brief Counts and genus of the mesh of landmarks, before it was triangulated (section 4.3).
   * \return its faces are the surface, its edges in no face the curve */
  const TopologyReport& getReport () const { return result_.report; }

  /** \brief The neighbourhood graph that was used.
   * \return over the distinct finite points of the cloud, or the given one, made proper */
  const manifold::NeighborhoodGraph& getNeighborhoodGraph () const { return cloud_graph_.graph; }

  /** \brief The points that are vertices of the neighbourhood graph.
   * \return per vertex its index in the input cloud */
  const pcl::Indices& getVertices () const { return cloud_graph_.input_index; }

  /** \brief How many points were left out because they stand for no measurement, see SampleSet.
   * \return of the last reconstruct () */
  std::size_t getNoMeasurementCount () const { return cloud_graph_.no_measurement; }

protected:
  using manifold::MeshBase<PointT>::input_;
  using manifold::MeshBase<PointT>::indices_;
  using manifold::MeshBase<PointT>::tree_;

  /** \brief As reconstruct (output).
   * \param[out] output see there */
  void performReconstruction (pcl::PolygonMesh& output) override { reconstruct (output); }

  /** \brief As reconstruct (polygons).
   * \param[out] polygons see there */
  void performReconstruction (std::vector<pcl::Vertices>& polygons) override { reconstruct (polygons); }

  /** \brief The name of the class.
   * \return without its namespace */
  std::string getClassName () const override { return "GraphReconstruction"; }

private:
  // Reconstructs, and then runs convert () as a part of that: it answers with a status, too.
  template <typename Convert>
  bool reconstructAnd (const Convert& convert);

  // The stages, from the input to result_.
  manifold::Status compute (manifold::StageLog& log);

  // The first of them: the neighbourhood graph of the input cloud, or the one that was given.
  manifold::Status makeGraph (manifold::StageLog& log);

  // The search of setSearchMethod (), if there is one.
  manifold::NeighborSearch givenSearch () const;

  manifold::GraphParameters parameters_;
  std::shared_ptr<const manifold::NeighborhoodGraph> given_graph_;
  PointRepresentationConstPtr representation_;
  manifold::CloudGraph cloud_graph_;
  manifold::GraphMesh result_;
};

} // namespace pcl

#include <pcl/manifold/impl/graph_reconstruction.hpp>
