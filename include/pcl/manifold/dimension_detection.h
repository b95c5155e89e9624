#pragma once

#include <pcl/PointIndices.h>
#include <pcl/manifold/detail/detect_dimensions.h>
#include <pcl/manifold/export.h>
#include <pcl/manifold/status.h>
#include <pcl/pcl_base.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace pcl {

/** \brief Tells for every point of a cloud the dimension of the shape that it lies on: 1 = curve, 2 =
 * surface, 3 = solid.
 *
 * DIMENSION of T. K. Dey, J. Giesen, S. Goswami, W. Zhao, "Shape dimension and approximation from samples",
 * Discrete and Computational Geometry 29 (2003), section 4: from the heights of the Voronoi subpolytopes of
 * each sample. The paper's guarantee holds for (eps, delta)-samples; real scans are no such samples unless
 * they are thinned to one, see setKSearch () and setSpacing ().
 *
 * What goes beyond the paper: getManifoldDimension () and getBoundary () decide from the labels of the
 * neighbours which manifold a point belongs to; the paper labels the rim of a surface 1 and the skin of a
 * solid 2.
 *
 * Points that are not finite, and rays without measurement (see SampleSet), get the label 0. On failure the
 * output is empty and getStatus () says why.
 *
 * Time and memory are those of a 3D Delaunay triangulation of the samples. The result is the same, bit for
 * bit, for any number of threads.
 *
 * \note The library is distributed under GPL-3, as CGAL's triangulations are.
 */
template <typename PointT>
class DimensionDetection : public PCLBase<PointT>
{
public:
  using Ptr = shared_ptr<DimensionDetection<PointT>>;
  using ConstPtr = shared_ptr<const DimensionDetection<PointT>>;

  /** \brief The largest ratio H1 / Hi at which subpolytope i still counts as a normal direction (section 4).
   * \param[in] rho in (0, 1]; 0.3 by default, as in section 6 of the paper */
  void setRho (double rho) { parameters_.rho = rho; }

  double getRho () const { return parameters_.rho; }

  /** \brief Thins the cloud to a greedy subset in which no point is among the k nearest neighbours of
   * another.
   * \param[in] k 0 = off (the default); 4 to 8 for airborne scans, 24 to 48 for random or noisy samples */
  void setKSearch (int k) { parameters_.thinning.k_search = k; }

  int getKSearch () const { return parameters_.thinning.k_search; }

  /** \brief Thins the cloud to a greedy subset in which no two points are nearer than a distance; before
   * setKSearch () where both are given.
   * \param[in] spacing in the unit of the cloud; 0 = off (the default) */
  void setSpacing (double spacing) { parameters_.thinning.spacing = spacing; }

  double getSpacing () const { return parameters_.thinning.spacing; }

  /** \param[in] threads 0 = all cores (the default) */
  void setNumberOfThreads (unsigned int threads) { parameters_.threads = threads; }

  unsigned int getNumberOfThreads () const { return parameters_.threads; }

  void setProgressCallback (manifold::ProgressCallback callback)
  {
    parameters_.progress = std::move (callback);
  }

  /** \brief Triangulation of the same cloud, indices and thinning to be used instead of a new one: the one of
   * another class of the module. Handed in for another cloud it is not used. */
  void setDelaunayComplex (std::shared_ptr<const manifold::DelaunayComplex> complex)
  {
    parameters_.complex = std::move (complex);
  }

  /** \brief The label of every point (of those that setIndices () names, in their order).
   * \param[out] output one label a point: 1, 2, 3, or 0 for points that are not finite or no measurement;
   * empty on failure */
  void compute (pcl::PointCloud<pcl::Label>& output);

  /** \brief How the last compute () ended. */
  manifold::Status getStatus () const { return status_; }

  /** \brief Per point the dimension of the manifold that it belongs to: 2 also at the rim of a surface, 3
   * also at the skin of a solid; 0 for points that are not finite or no measurement. */
  std::vector<std::uint8_t> getManifoldDimension () const;

  /** \brief Per point whether it is on the boundary of its manifold: rim, skin or end of a curve. */
  std::vector<std::uint8_t> getBoundary () const;

  /** \brief Per point how far its ratios of heights are from rho, in [0, 1]. */
  std::vector<float> getConfidence () const;

  /** \brief Per point the heights H1, H2, H3 of its Voronoi subpolytopes (Definition 2.3), 3 x n, in the unit
   * of the cloud; infinite where a subpolytope is unbounded, NaN for points that are not finite. Points that
   * were thinned out have those of the nearest sample, here and above. */
  Eigen::Matrix3Xd getHeights () const;

  /** \brief Indices into the input cloud of the points that were kept as samples. */
  pcl::Indices getSamples () const;

  /** \brief The triangulation of the samples, to be handed to another class; null before compute (). */
  std::shared_ptr<const manifold::DelaunayComplex> getDelaunayComplex () const
  {
    return result_ ? result_->complex : nullptr;
  }

  /** \brief Everything that was found, per sample, to be handed to CoconeShape; null before compute (). */
  std::shared_ptr<const manifold::SampleDimensions> getSampleDimensions () const { return result_; }

  /** \brief How many samples were taken for ones of a curve although others lie beside it: if most, the points
   * are those of a surface in rows that are nearer along than across, or they are noisy, and thinning with
   * setKSearch (8) or so makes them even. 0 before compute (). */
  std::size_t getContradictedCount () const { return result_ ? result_->contradicted : 0; }

  /** \brief Seconds and peak memory of each stage of the last compute (). */
  const std::vector<manifold::Stage>& getStages () const { return stages_; }

protected:
  using PCLBase<PointT>::input_;
  using PCLBase<PointT>::indices_;
  using PCLBase<PointT>::initCompute;
  using PCLBase<PointT>::deinitCompute;

private:
  // value (sample) for every point, or none for those that are not finite.
  template <typename T, typename Value>
  std::vector<T> perPoint (T none, const Value& value) const;

  manifold::DimensionParameters parameters_;
  std::shared_ptr<const manifold::SampleDimensions> result_;
  std::vector<manifold::Stage> stages_;
  manifold::Status status_ = manifold::Status::NOT_COMPUTED;
};

} // namespace pcl

#include <pcl/manifold/impl/dimension_detection.hpp>
