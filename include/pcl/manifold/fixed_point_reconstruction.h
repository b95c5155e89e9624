#pragma once

#include <pcl/PolygonMesh.h>
#include <pcl/manifold/complex_reconstruction.h>
#include <pcl/manifold/reconstruct_fixed_point.h>
#include <pcl/manifold/simplicial_complex.h>
#include <pcl/manifold/status.h>

#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace pcl {

namespace manifold {

/** \brief How many triangles of each kind FixedPointReconstruction found.
 * \ingroup manifold */
struct FixedPointCounts
{
  std::size_t anchored = 0; ///< Delaunay triangles that meet their own dual Voronoi edges
  std::size_t medial = 0; ///< those of them near the medial axis; they can be in the complex as chained ones
  std::size_t chained =
    0; ///< what the others generate: the complex has anchored - medial + chained triangles
};

} // namespace manifold

/** \brief Reconstructs a surface over the points of a cloud.
 *
 * The method of M. Khoury, J. R. Shewchuk, "Fixed points of the restricted Delaunay triangulation operator",
 * 32nd International Symposium on Computational Geometry (SoCG 2016). Of all Delaunay triangles it takes
 * those that can be in a triangulation T which the restricted Delaunay operator maps to itself (T is made of
 * the triangles whose dual Voronoi edges meet T), and which stays near the surface: the manifold fixed-point
 * complex, see getComplex (). Then it extracts a manifold from these, as CoconeShape does: edge- and
 * vertex-manifold, with or without boundary, consistently oriented where that is possible.
 *
 * The guarantee: if the points are a 0.143-sample of a smooth closed surface, which means that from every
 * place of it there is a point within 0.143 times its distance to the medial axis, then with
 * setCriticalRatio (0.313) and setVotes (1) a part of the complex is homeomorphic to that surface and all of
 * it is near to it (Theorem 13). The walk of section 8 from the outside finds that part, and is what extracts
 * it with these constants wherever it encloses all samples.
 *
 * Clouds of scanners are coarser than that at every edge, and with these constants fall apart there; the
 * defaults are for them, and so are the extraction of CoconeShape, which keeps the rims of open surfaces, and
 * setWatertight (). No theorem covers those. A hole in a surface that is flat all around it is closed. A
 * stray point beside the surface may become a spike of it: remove such points first.
 *
 * setInitialMesh () starts from a mesh instead, whose vertices may be other points than those of the cloud.
 *
 * On failure the output is empty and getStatus () says why: NO_INPUT, TOO_FEW_POINTS for fewer than three
 * distinct points, DIMENSION_TOO_LOW for points on a line and where no surface was found,
 * PARAMETER_OUT_OF_RANGE, INPUT_TOO_COARSE, INPUT_OUT_OF_RANGE, TOO_MANY_POINTS, CANCELLED, OUT_OF_MEMORY,
 * INTERNAL_ERROR (also where the progress callback throws). Time and memory are those of a 3D Delaunay
 * triangulation of the points. The result is the same, bit for bit, for any number of threads and, up to
 * renumbering, for any order of the points.
 *
 * \note The library is distributed under GPL-3, as CGAL's triangulations are.
 * \ingroup manifold */
template <typename PointT>
class FixedPointReconstruction : public manifold::ComplexReconstruction<PointT>
{
public:
  /** \brief A shared pointer to an object of this class. */
  using Ptr = shared_ptr<FixedPointReconstruction<PointT>>;

  /** \brief A shared pointer to a constant object of this class. */
  using ConstPtr = shared_ptr<const FixedPointReconstruction<PointT>>;

  /** \brief Every parameter has its default. */
  FixedPointReconstruction () : manifold::ComplexReconstruction<PointT> ("FixedPointReconstruction")
  {
    critical_.ratio = 0.8;
    critical_.votes = 3;
  }

  /** \brief Which circumcentres of triangles are near the medial axis, not near the surface: those further
   * from a corner of their triangle than this times the distance of the corner's pole, the far end of its
   * Voronoi cell (section 8).
   * \param[in] ratio more than 0, else reconstruct () ends in PARAMETER_OUT_OF_RANGE; 0.8 by default, found by
   * measurement over many meshes and scans. 0.313 is the published constant, which the guarantee needs (with
   * setVotes (1)); where points are further apart than it asks for it leaves gaps. From 1 on gaps and rims
   * are closed that are none of the samples' */
  void setCriticalRatio (double ratio) { critical_.ratio = ratio; }

  /** \brief The ratio from which on a circumcentre is near the medial axis.
   * \return see setCriticalRatio () */
  double getCriticalRatio () const { return critical_.ratio; }

  /** \brief How many of its three corners have to say so before a triangle is taken for medial. In a
   * 0.143-sample all agree.
   * \param[in] votes 1 to 3, else reconstruct () ends in PARAMETER_OUT_OF_RANGE; 3 by default */
  void setVotes (int votes) { critical_.votes = votes; }

  /** \brief The number of corners that make a triangle medial.
   * \return see setVotes () */
  int getVotes () const { return critical_.votes; }

  /** \brief Starts the restricted Delaunay operator from a mesh and applies it until nothing changes: the
   * fixed point is the result as it is, without any extraction, and setWatertight () has no effect. From a
   * mesh near the surface, as that of GraphReconstruction over a few of the points, this leads to one over
   * all of them; where the mesh is too far away to be a good start the result may have edges of more than two
   * triangles, and holes; one that meets no Voronoi edge leads to nothing, with the status OK.
   * \param[in] mesh in the coordinates of the cloud; read when reconstruct () is called, which refuses a mesh
   * without faces, or with vertices that are not finite, as PARAMETER_OUT_OF_RANGE. Polygons of fewer than
   * three corners are left out. Null (the default) for none */
  void setInitialMesh (const pcl::PolygonMesh::ConstPtr& mesh) { initial_mesh_ = mesh; }

  /** \brief The mesh from which the operator starts.
   * \return null for none */
  pcl::PolygonMesh::ConstPtr getInitialMesh () const { return initial_mesh_; }

  /** \brief The manifold fixed-point complex of the last reconstruct () (section 8), which need not be a
   * manifold, before any extraction; with an initial mesh the fixed point.
   * \return triangles over the points of the input cloud, not oriented; empty unless the status is OK */
  pcl::SimplicialComplex getComplex () const
  {
    return result_.complex ? manifold::facetShape (*result_.complex, result_.found.facets)
                           : pcl::SimplicialComplex ();
  }

  /** \brief How often the operator was applied to the initial mesh, and to what came of it, before nothing
   * changed.
   * \return at least 1; 0 without an initial mesh and unless the status is OK */
  int getIterations () const { return result_.iterations; }

  /** \brief The numbers of triangles of each kind.
   * \return zeros with an initial mesh and unless the status is OK */
  manifold::FixedPointCounts getCounts () const
  {
    return {result_.found.anchored, result_.found.medial_anchored, result_.found.chained};
  }

  /** \brief The triangulation that the last reconstruct () worked on.
   * \return null unless the status is OK */
  std::shared_ptr<const manifold::DelaunayComplex> getDelaunayComplex () const { return result_.complex; }

protected:
  using manifold::ComplexReconstruction<PointT>::input_;
  using manifold::ComplexReconstruction<PointT>::indices_;

  manifold::Status compute (manifold::StageLog& log, pcl::SimplicialComplex& complex) override;

  void forget () noexcept override { result_ = manifold::FixedPointResult (); }

private:
  manifold::CriticalPointParameters critical_;
  pcl::PolygonMesh::ConstPtr initial_mesh_;
  manifold::FixedPointResult result_;
};

} // namespace pcl

#include <pcl/manifold/impl/fixed_point_reconstruction.hpp>
