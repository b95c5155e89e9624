#pragma once

#include <pcl/manifold/complex_reconstruction.h>
#include <pcl/manifold/dimension_detection.h>
#include <pcl/manifold/reconstruct_shape.h>
#include <pcl/manifold/simplicial_complex.h>

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
 * On failure the output is empty and getStatus () says why: NO_INPUT, DIMENSION_TOO_LOW where all points are
 * equal, PARAMETER_OUT_OF_RANGE, INPUT_TOO_COARSE, INPUT_OUT_OF_RANGE, CANCELLED, OUT_OF_MEMORY,
 * INTERNAL_ERROR. Time and memory are those of a 3D Delaunay triangulation of the samples, O (n) on surfaces
 * met in practice and O (n^2) at worst. The result is the same, bit for bit, for any number of threads and,
 * up to renumbering, for any order of the points.
 *
 * \note The library is distributed under GPL-3, as CGAL's triangulations are.
 * \ingroup manifold */
template <typename PointT>
class CoconeShape : public manifold::ComplexReconstruction<PointT>
{
public:
  /** \brief A shared pointer to an object of this class. */
  using Ptr = shared_ptr<CoconeShape<PointT>>;

  /** \brief A shared pointer to a constant object of this class. */
  using ConstPtr = shared_ptr<const CoconeShape<PointT>>;

  /** \brief Every parameter has its default. */
  CoconeShape () : manifold::ComplexReconstruction<PointT> ("CoconeShape") {}

  /** \brief The largest ratio H1 / Hi at which subpolytope i still counts as a normal direction (section 4).
   * \param[in] rho in (0, 1], else reconstruct () ends in PARAMETER_OUT_OF_RANGE; 0.3 by default, as in section
   * 6 of the paper */
  void setRho (double rho) { rho_ = rho; }

  /** \brief The largest ratio of heights of a normal direction.
   * \return see setRho () */
  double getRho () const { return rho_; }

  /** \brief Dimensions of the same cloud, indices and thinning, of DimensionDetection::getSampleDimensions (),
   * to be used instead of new ones; their rho counts.
   * \param[in] dimensions not used where they are of another cloud; null (the default) for new ones */
  void setSampleDimensions (std::shared_ptr<const manifold::SampleDimensions> dimensions)
  {
    given_dimensions_ = std::move (dimensions);
  }

  /** \brief The candidate simplices of the last reconstruct (), as published (the set T of section 5), which
   * need not form manifolds.
   * \return over the points of the input cloud; empty before */
  pcl::SimplicialComplex getCandidates () const
  {
    return dimensions_ ? manifold::candidateShape (*dimensions_) : pcl::SimplicialComplex ();
  }

  /** \brief The dimensions that the last reconstruct () worked on.
   * \return null before, and where it failed */
  std::shared_ptr<const manifold::SampleDimensions> getSampleDimensions () const { return dimensions_; }

  /** \brief How many samples were taken for ones of a curve although others lie beside it. If most, the points
   * are those of a surface in rows that are nearer along than across, or they are noisy, and thinning with
   * setThinningNeighbors (8) or so makes them even.
   * \return of the samples; 0 before reconstruct () */
  std::size_t getContradictedCount () const { return dimensions_ ? dimensions_->contradicted : 0; }

  /** \brief The triangulation that the last reconstruct () worked on.
   * \return null before, and where it failed */
  std::shared_ptr<const manifold::DelaunayComplex> getDelaunayComplex () const
  {
    return dimensions_ ? dimensions_->complex : nullptr;
  }

protected:
  using manifold::ComplexReconstruction<PointT>::input_;
  using manifold::ComplexReconstruction<PointT>::indices_;

  manifold::Status compute (manifold::StageLog& log, pcl::SimplicialComplex& complex) override;

  void forget () noexcept override { dimensions_.reset (); }

private:
  double rho_ = manifold::DimensionParameters ().rho;
  std::shared_ptr<const manifold::SampleDimensions> given_dimensions_;
  std::shared_ptr<const manifold::SampleDimensions> dimensions_;
};

} // namespace pcl

#include <pcl/manifold/impl/cocone_shape.hpp>
