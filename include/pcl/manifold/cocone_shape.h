#pragma once

#include <pcl/manifold/detail/reconstruct_shape.h>
#include <pcl/manifold/dimension_detection.h>
#include <pcl/manifold/simplicial_complex.h>
#include <pcl/surface/reconstruction.h>

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace pcl {

/** \brief Reconstructs the curves, surfaces and solids of a scene of mixed dimension over the points of a
 * cloud.
 *
 * COCONESHAPE of T. K. Dey, J. Giesen, S. Goswami, W. Zhao, "Shape dimension and approximation from samples",
 * Discrete and Computational Geometry 29 (2003), section 5: for a sample of dimension k the k-simplices dual
 * to the Voronoi faces of dimension 3 - k that its cocone (angle pi/8) meets; getCandidates () gives them as
 * published.
 *
 * reconstruct () then extracts manifolds from them, in ways of its own where the paper refers to Cocone's:
 * polylines in which every inner vertex has two edges; surfaces with or without boundary, edge- and
 * vertex-manifold and oriented consistently where that is possible; solids of tetrahedra with a manifold
 * boundary.
 *
 * On failure the output is empty and getStatus () says why. Time and memory are those of a 3D Delaunay
 * triangulation of the samples. The result is the same, bit for bit, for any number of threads.
 *
 * \note The library is distributed under GPL-3, as CGAL's triangulations are.
 */
template <typename PointT>
class CoconeShape : public MeshConstruction<PointT>
{
public:
  using Ptr = shared_ptr<CoconeShape<PointT>>;
  using ConstPtr = shared_ptr<const CoconeShape<PointT>>;

  CoconeShape ()
  {
    // The Delaunay triangulation is all the search that is needed.
    this->check_tree_ = false;
  }

  /** \brief See DimensionDetection::setRho. */
  void setRho (double rho) { parameters_.dimension.rho = rho; }

  double getRho () const { return parameters_.dimension.rho; }

  /** \brief See DimensionDetection::setKSearch. */
  void setKSearch (int k) { parameters_.dimension.thinning.k_search = k; }

  int getKSearch () const { return parameters_.dimension.thinning.k_search; }

  /** \brief See DimensionDetection::setSpacing. */
  void setSpacing (double spacing) { parameters_.dimension.thinning.spacing = spacing; }

  double getSpacing () const { return parameters_.dimension.thinning.spacing; }

  /** \param[in] threads 0 = all cores (the default) */
  void setNumberOfThreads (unsigned int threads) { parameters_.dimension.threads = threads; }

  unsigned int getNumberOfThreads () const { return parameters_.dimension.threads; }

  void setProgressCallback (manifold::ProgressCallback callback)
  {
    parameters_.dimension.progress = std::move (callback);
  }

  /** \brief Closes every surface: what the samples leave open is spanned by Delaunay triangles.
   * \param[in] watertight false by default */
  void setWatertight (bool watertight) { parameters_.watertight = watertight; }

  bool getWatertight () const { return parameters_.watertight; }

  /** \brief Triangulation of the same cloud, indices and thinning to be used instead of a new one. Handed in
   * for another cloud it is not used. */
  void setDelaunayComplex (std::shared_ptr<const manifold::DelaunayComplex> complex)
  {
    parameters_.dimension.complex = std::move (complex);
  }

  /** \brief Dimensions of the same cloud, indices and thinning, of DimensionDetection::getSampleDimensions
   * (), to be used instead of new ones; its rho counts. Handed in for another cloud they are not used. */
  void setSampleDimensions (std::shared_ptr<const manifold::SampleDimensions> dimensions)
  {
    parameters_.dimension.dimensions = std::move (dimensions);
  }

  /** \brief Edges and triangles as polygons over all points of the input cloud; solids by their boundary.
   * \param[out] output empty on failure */
  void reconstruct (pcl::PolygonMesh& output) override;

  /** \brief As above, polygons only. */
  void reconstruct (std::vector<pcl::Vertices>& polygons) override;

  /** \brief Everything: edges, triangles and tetrahedra over the points of the input cloud.
   * \param[out] output empty on failure */
  void reconstruct (pcl::SimplicialComplex& output);

  /** \brief The candidate simplices of the last reconstruct (), as published (the set T of section 5), which
   * need not form manifolds; empty before. */
  pcl::SimplicialComplex getCandidates () const
  {
    return dimensions_ ? manifold::candidateShape (*dimensions_) : pcl::SimplicialComplex ();
  }

  /** \brief How the last reconstruct () ended. */
  manifold::Status getStatus () const { return status_; }

  /** \brief The dimensions that the last reconstruct () worked on, null before. */
  std::shared_ptr<const manifold::SampleDimensions> getSampleDimensions () const { return dimensions_; }

  /** \brief How many samples were taken for ones of a curve although others lie beside it: if most, the points
   * are those of a surface in rows that are nearer along than across, or they are noisy, and thinning with
   * setKSearch (8) or so makes them even. 0 before reconstruct (). */
  std::size_t getContradictedCount () const { return dimensions_ ? dimensions_->contradicted : 0; }

  /** \brief The triangulation that the last reconstruct () worked on, null before. */
  std::shared_ptr<const manifold::DelaunayComplex> getDelaunayComplex () const
  {
    return dimensions_ ? dimensions_->complex : nullptr;
  }

  /** \brief Seconds and peak memory of each stage of the last reconstruct (). */
  const std::vector<manifold::Stage>& getStages () const { return stages_; }

protected:
  using MeshConstruction<PointT>::input_;
  using MeshConstruction<PointT>::indices_;
  using MeshConstruction<PointT>::initCompute;
  using MeshConstruction<PointT>::deinitCompute;

  void performReconstruction (pcl::PolygonMesh& output) override;

  void performReconstruction (std::vector<pcl::Vertices>& polygons) override;

  std::string getClassName () const override { return "CoconeShape"; }

private:
  manifold::ShapeParameters parameters_;
  std::shared_ptr<const manifold::SampleDimensions> dimensions_;
  std::vector<manifold::Stage> stages_;
  manifold::Status status_ = manifold::Status::NOT_COMPUTED;
};

} // namespace pcl

#include <pcl/manifold/impl/cocone_shape.hpp>
