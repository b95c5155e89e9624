#pragma once

#include <pcl/PolygonMesh.h>
#include <pcl/manifold/delaunay_computation.h>
#include <pcl/manifold/detail/mesh_base.h>
#include <pcl/manifold/simplicial_complex.h>

#include <string>
#include <vector>

namespace pcl {
namespace manifold {

/** \brief The base of the classes that reconstruct a complex over the points of a cloud: CoconeShape and
 * FixedPointReconstruction.
 *
 * It derives from pcl::MeshConstruction for PCL's own point types with x, y and z, and from its base
 * pcl::PCLSurfaceBase, with the same functions, for all others: those need no PCL_NO_PRECOMPILE.
 *
 * The Delaunay triangulation is all the search that is needed. A search that setSearchMethod () of PCL's base
 * class is given is not used, and the first reconstruct () after that says so through PCL_WARN.
 *
 * \ingroup manifold */
template <typename PointT>
class ComplexReconstruction : public DelaunayComputation<MeshBase<PointT>>
{
public:
  /** \brief Closes every surface: what the samples leave open is spanned by Delaunay triangles.
   * \param[in] watertight false by default */
  void setWatertight (bool watertight) { watertight_ = watertight; }

  /** \brief Whether every surface is closed.
   * \return see setWatertight () */
  bool getWatertight () const { return watertight_; }

  /** \brief Reconstructs a mesh: edges as polygons of two vertices, then triangles, with tetrahedra by their
   * boundary, over all points of the input cloud, used or not.
   * \param[out] output its cloud has all fields, the layout and the header of the input; empty on failure, see
   * getStatus () */
  void reconstruct (pcl::PolygonMesh& output) override;

  /** \brief As above, polygons only.
   * \param[out] polygons index the input cloud; empty on failure */
  void reconstruct (std::vector<pcl::Vertices>& polygons) override;

  /** \brief Reconstructs a complex: edges, triangles and tetrahedra.
   * \param[out] output over the points of the input cloud; empty on failure, see getStatus () */
  void reconstruct (pcl::SimplicialComplex& output);

protected:
  /** \brief For the classes that derive from this one.
   * \param[in] name of the class, a literal */
  explicit ComplexReconstruction (const char* name) : name_ (name)
  {
    // The base class is to index nothing.
    this->check_tree_ = false;
  }

  /** \brief From the valid input to the results and the complex.
   * \param[in,out] log of the stages
   * \param[out] complex over the points of the input cloud
   * \return OK, or why there is none */
  virtual Status compute (StageLog& log, pcl::SimplicialComplex& complex) = 0;

  /** \brief Leaves no result for the getters. */
  virtual void forget () noexcept = 0;

  /** \brief As reconstruct (output).
   * \param[out] output see there */
  void performReconstruction (pcl::PolygonMesh& output) override { reconstruct (output); }

  /** \brief As reconstruct (polygons).
   * \param[out] polygons see there */
  void performReconstruction (std::vector<pcl::Vertices>& polygons) override { reconstruct (polygons); }

  /** \brief The name of the class.
   * \return without its namespace */
  std::string getClassName () const override { return name_; }

private:
  // Reconstructs, and then runs convert (complex) as a part of that: it answers with a status, too.
  template <typename Convert>
  bool reconstructAnd (const Convert& convert);

  // The complex over the input cloud as a mesh.
  Status toMesh (const pcl::SimplicialComplex& complex, pcl::PolygonMesh& mesh) const;

  const char* name_;
  bool watertight_ = false;
  bool warned_of_search_ = false;
};

} // namespace manifold
} // namespace pcl

#include <pcl/manifold/impl/complex_reconstruction.hpp>
