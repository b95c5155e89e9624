#pragma once

#include <pcl/PointIndices.h>
#include <pcl/manifold/delaunay_computation.h>
#include <pcl/manifold/detect_dimensions.h>
#include <pcl/manifold/export.h>
#include <pcl/manifold/scale_dimensions.h>
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

namespace manifold {

/** \brief How many scales DimensionDetection looks at.
 * \ingroup manifold */
enum class Scales
{
  ALL, ///< a ladder of spacings, and the label that persists over it
  OFF  ///< the points as they are, or as they are thinned: the method as published
};

} // namespace manifold

/** \brief Tells for every point of a cloud the dimension of the shape that it lies on: 1 = curve, 2 =
 * surface, 3 = solid.
 *
 * DIMENSION of T. K. Dey, J. Giesen, S. Goswami, W. Zhao, "Shape dimension and approximation from samples",
 * Discrete and Computational Geometry 29 (2003), section 4: from the heights of the Voronoi subpolytopes of
 * each sample. The paper's guarantee holds for (eps, delta)-samples: dense where the shape has detail, and
 * nowhere clustered. A scan is none, but it becomes one at the right spacing, which differs from place to
 * place. So the method is applied to a ladder of thinned clouds whose spacings grow by the square root of
 * two, and a point takes the label that persists; getScale () says from which spacing on, getPersistence ()
 * over how many octaves. Frames of a spinning lidar are looked at in coordinates of the sensor. All that is
 * of this library; setScales (OFF) applies the published method once, to the points as they are.
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

  /** \brief Whether the dimension is asked for at all scales. Of this library, not in the paper.
   * \param[in] scales ALL by default; OFF for the published method alone */
  void setScales (manifold::Scales scales) { scales_ = scales; }

  /** \brief Whether the dimension is asked for at all scales.
   * \return see setScales () */
  manifold::Scales getScales () const { return scales_; }

  /** \brief Which scales to ask at: a trunk is a surface at 2 cm and a curve at half a metre.
   * \param[in] from the finest spacing, in the unit of the cloud
   * \param[in] to the coarsest one; 0 and 0 (the default) for from the spacing of the points to an eighth of the
   * extent. Negative, not finite or upside down ends in PARAMETER_OUT_OF_RANGE,
   * and so does a range together with setSensorOrigin (); the cloud's own origin is not looked at then */
  void setScaleRange (double from, double to)
  {
    scale_parameters_.from = from;
    scale_parameters_.to = to;
  }

  /** \brief Where the sensor of a single frame stood. Rings of a spinning lidar are no curves then, and near and far
   * things are looked at alike. Not for a map of several frames.
   *
   * If this is not called, the cloud's own sensor_origin_ counts where it is not 0 0 0; and a frame of rings
   * around 0 0 0, where drivers put the sensor, is recognised.
   * \param[in] origin in the coordinates of the cloud; not finite ends in PARAMETER_OUT_OF_RANGE, so far away that
   * the points cannot be told apart from there in INPUT_OUT_OF_RANGE */
  void setSensorOrigin (const Eigen::Vector3d& origin) { scale_parameters_.sensor_origin = origin; }

  /** \brief The label of every point, as published, of the scale from which on its manifold dimension persists.
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

  /** \brief How far the ratios of the heights of each point are from rho, on average over the scales at which its
   * label persists.
   * \return per label in [0, 1]: 0 on the edge between two answers, and for points that are not finite */
  std::vector<float> getConfidence () const;

  /** \brief From which scale on each point has its manifold dimension.
   * \return per label a spacing in the unit of the cloud, 0 for points that are not finite; empty with
   * setScales (OFF) */
  std::vector<float> getScale () const;

  /** \brief Over how many octaves of scale it persists.
   * \return per label; empty with setScales (OFF) */
  std::vector<float> getPersistence () const;

  /** \brief The direction of the curve at each point of one.
   * \return a unit vector a label, 0 for points of no curve; no columns with setScales (OFF) */
  Eigen::Matrix3Xf getTangents () const;

  /** \brief The curve that each point belongs to.
   * \return per label an index into getCurves (), or -1; empty with setScales (OFF) */
  std::vector<std::int32_t> getCurveOfPoint () const;

  /** \brief What curves there are: wires, poles, branches.
   * \return their measures; empty with setScales (OFF) */
  std::vector<manifold::CurveMeasures> getCurves () const
  {
    return persistent_ ? persistent_->curves : std::vector<manifold::CurveMeasures> ();
  }

  /** \brief The sensor's place that was used.
   * \return empty where none was known or recognised */
  std::optional<Eigen::Vector3d> getSensorOrigin () const
  {
    return persistent_ ? persistent_->sensor_origin : std::optional<Eigen::Vector3d> ();
  }

  /** \brief The heights H1, H2, H3 of the Voronoi subpolytopes of each point (Definition 2.3).
   * \return a column a label, in the unit of the cloud; infinite where a subpolytope is unbounded, NaN for
   * points that are not finite; of the finest scale, and no columns where the sensor's place is known */
  Eigen::Matrix3Xd getHeights () const;

  /** \brief The points that were kept as samples.
   * \return indices into the input cloud */
  pcl::Indices getSamples () const;

  /** \brief The distinct points that the answers are of, and what was left out.
   * \return null before compute (), and where it failed */
  std::shared_ptr<const manifold::SampleSet> getSampleSet () const { return samples_; }

  /** \brief The triangulation of the samples, to be handed to another class.
   * \return null before compute (), where it failed, and where the sensor's place is known: the cloud was
   * triangulated in other coordinates then */
  std::shared_ptr<const manifold::DelaunayComplex> getDelaunayComplex () const
  {
    return result_ ? result_->complex : nullptr;
  }

  /** \brief What the published method finds, per sample, to be handed to CoconeShape.
   * \return null as getDelaunayComplex () */
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
  // From the valid input to the results.
  manifold::Status detect (manifold::StageLog& log);

  void clear ();

  // A label for every point, in the layout of the cloud.
  void giveLabels (pcl::PointCloud<pcl::Label>& output) const;

  // value (sample) for every point, or none for those that are not finite.
  template <typename T, typename Value>
  std::vector<T> perPoint (T none, const Value& value) const;

  // That of a point's sample, of the array that the scales have or else of the one of the single scale.
  template <typename T>
  std::vector<T> perPoint (T none, const std::vector<T> manifold::ScaleDimensions::*of_scales,
                           const std::vector<T> manifold::SampleDimensions::*of_one) const;

  double rho_ = manifold::DimensionParameters ().rho;
  manifold::Scales scales_ = manifold::Scales::ALL;
  manifold::ScaleParameters scale_parameters_;
  std::shared_ptr<const manifold::SampleSet> samples_;
  std::shared_ptr<const manifold::SampleDimensions> result_;
  std::shared_ptr<const manifold::ScaleDimensions> persistent_;
};

} // namespace pcl

#include <pcl/manifold/impl/dimension_detection.hpp>
