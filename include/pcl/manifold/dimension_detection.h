#pragma once

#include <pcl/PointIndices.h>
#include <pcl/manifold/delaunay_computation.h>
#include <pcl/manifold/detect_dimensions.h>
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
 * they are thinned to one, see setThinningNeighbors () and setThinningDistance ().
 *
 * What goes beyond the paper: getManifoldDimension () and getBoundary () decide from the labels of the
 * neighbours which manifold a point belongs to; the paper labels the rim of a surface 1 and the skin of a
 * solid 2.
 *
 * Points that are not finite, and rays without measurement (see SampleSet), get the label 0. On failure the
 * output is empty and getStatus () says why: NO_INPUT, PARAMETER_OUT_OF_RANGE, INPUT_TOO_COARSE,
 * INPUT_OUT_OF_RANGE, TOO_MANY_POINTS, CANCELLED, OUT_OF_MEMORY, INTERNAL_ERROR.
 *
 * Time and memory are those of a 3D Delaunay triangulation of the samples, O (n) on surfaces met in practice
 * and O (n^2) at worst. The result is the same, bit for bit, for any number of threads and for any order of
 * the points.
 *
 * \note The library is distributed under GPL-3, as CGAL's triangulations are.
 * \ingroup manifold */
template <typename PointT>
class DimensionDetection : public manifold::DelaunayComputation<PCLBase<PointT>>
{
public:
  /** \brief A shared pointer to an object of this class. */
  using Ptr = shared_ptr<DimensionDetection<PointT>>;

  /** \brief A shared pointer to a constant object of this class. */
  using ConstPtr = shared_ptr<const DimensionDetection<PointT>>;

  /** \brief The largest ratio H1 / Hi at which subpolytope i still counts as a normal direction (section 4).
   * \param[in] rho in (0, 1], else compute () ends in PARAMETER_OUT_OF_RANGE; 0.3 by default, as in section 6 of
   * the paper */
  void setRho (double rho) { rho_ = rho; }

  /** \brief The largest ratio of heights of a normal direction.
   * \return see setRho () */
  double getRho () const { return rho_; }

  /** \brief The label of every point, as published.
   * \param[out] output one label a point of the cloud, or of those that setIndices () names, in their order: 1,
   * 2, 3, or 0 for points that are not finite or no measurement. It has the header and the sensor's pose of
   * the cloud, and its width and height if every point has a label in its place. Empty on failure, see
   * getStatus () */
  void compute (pcl::PointCloud<pcl::Label>& output);

  // What the last compute () found; nothing unless its status was OK. Points that were thinned out have the
  // answers of the nearest sample.

  /** \brief The dimension of the manifold that each point belongs to. Of this library, not in the paper.
   * \return per label: 2 also at the rim of a surface, 3 also at the skin of a solid; 0 for points that are not
   * finite or no measurement */
  std::vector<std::uint8_t> getManifoldDimension () const;

  /** \brief Whether each point is on the boundary of its manifold: rim, skin or end of a curve. Of this library,
   * not in the paper.
   * \return per label: 1 on the boundary, else 0 */
  std::vector<std::uint8_t> getBoundary () const;

  /** \brief How far the ratios of the heights of each point are from rho.
   * \return per label in [0, 1]: 0 on the edge between two answers, and for points that are not finite */
  std::vector<float> getConfidence () const;

  /** \brief The heights H1, H2, H3 of the Voronoi subpolytopes of each point (Definition 2.3).
   * \return a column a label, in the unit of the cloud; infinite where a subpolytope is unbounded, NaN for
   * points that are not finite */
  Eigen::Matrix3Xd getHeights () const;

  /** \brief The points that were kept as samples.
   * \return indices into the input cloud */
  pcl::Indices getSamples () const;

  /** \brief The distinct points that the answers are of, and what was left out.
   * \return null before compute (), and where it failed */
  std::shared_ptr<const manifold::SampleSet> getSampleSet () const { return samples_; }

  /** \brief The triangulation of the samples, to be handed to another class.
   * \return null before compute (), and where it failed */
  std::shared_ptr<const manifold::DelaunayComplex> getDelaunayComplex () const
  {
    return result_ ? result_->complex : nullptr;
  }

  /** \brief Everything that was found, per sample, to be handed to CoconeShape.
   * \return null before compute (), and where it failed */
  std::shared_ptr<const manifold::SampleDimensions> getSampleDimensions () const { return result_; }

  /** \brief How many samples were taken for ones of a curve although others lie beside it. If most, the points
   * are those of a surface in rows that are nearer along than across, or they are noisy, and thinning with
   * setThinningNeighbors (8) or so makes them even.
   * \return of the samples; 0 before compute () */
  std::size_t getContradictedCount () const { return result_ ? result_->contradicted : 0; }

protected:
  using PCLBase<PointT>::input_;
  using PCLBase<PointT>::indices_;

private:
  // From the valid input to result_.
  manifold::Status detect (manifold::StageLog& log);

  // A label for every point, in the layout of the cloud.
  void giveLabels (pcl::PointCloud<pcl::Label>& output) const;

  // value (sample) for every point, or none for those that are not finite.
  template <typename T, typename Value>
  std::vector<T> perPoint (T none, const Value& value) const;

  double rho_ = manifold::DimensionParameters ().rho;
  std::shared_ptr<const manifold::SampleDimensions> result_;
};

} // namespace pcl

#include <pcl/manifold/impl/dimension_detection.hpp>
