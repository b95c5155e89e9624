#pragma once

#include <pcl/manifold/computation.h>
#include <pcl/manifold/delaunay_complex.h>
#include <pcl/manifold/sample_set.h>

#include <memory>
#include <utility>

namespace pcl {
namespace manifold {

/** \brief What the classes of the Delaunay family have in common: the cloud can be thinned to a sample, and the
 * triangulation of the sample is shared.
 *
 * Scans are dense in places and sparse in others, where theory wants evenly spread samples; thinning makes
 * them so. Points that are thinned out take the answer of the nearest sample and are no vertices of a mesh.
 *
 * \note The library is distributed under GPL-3, as CGAL's triangulations are.
 *
 * \tparam Base pcl::PCLBase<PointT> or a class that derives from it
 * \ingroup manifold */
template <typename Base>
class DelaunayComputation : public Computation<Base>
{
public:
  /** \brief Thins the cloud to a greedy subset in which no point is among the k nearest neighbours of another.
   * \param[in] k 0 = off (the default); 4 to 8 for airborne scans, 24 to 48 for random or noisy samples; less
   * than 0 ends in PARAMETER_OUT_OF_RANGE */
  void setThinningNeighbors (int k) { thinning_.neighbors = k; }

  /** \brief The number of neighbours by which the cloud is thinned.
   * \return 0 = off */
  int getThinningNeighbors () const { return thinning_.neighbors; }

  /** \brief Thins the cloud to a greedy subset in which no two points are nearer than a distance; before
   * setThinningNeighbors () where both are given.
   * \param[in] distance in the unit of the cloud; 0 = off (the default); negative or not finite ends in
   * PARAMETER_OUT_OF_RANGE */
  void setThinningDistance (double distance) { thinning_.distance = distance; }

  /** \brief The distance by which the cloud is thinned.
   * \return in the unit of the cloud; 0 = off */
  double getThinningDistance () const { return thinning_.distance; }

  /** \brief A triangulation of the same cloud, indices and thinning to be used instead of a new one: the one of
   * another class of the module.
   * \param[in] complex not used where it is of another cloud; null (the default) for a new one */
  void setDelaunayComplex (std::shared_ptr<const DelaunayComplex> complex) { complex_ = std::move (complex); }

protected:
  /** \brief Sets what the family has in common on the parameters of a stage function.
   * \param[in,out] parameters DimensionParameters or FixedPointParameters */
  template <typename Parameters>
  void setShared (Parameters& parameters) const
  {
    parameters.thinning = thinning_;
    parameters.threads = this->getNumberOfThreads ();
    parameters.complex = complex_;
  }

private:
  Thinning thinning_;
  std::shared_ptr<const DelaunayComplex> complex_;
};

} // namespace manifold
} // namespace pcl
