#pragma once

#include <pcl/impl/pcl_base.hpp> // for point types that PCL does not instantiate itself
#include <pcl/manifold/dimension_detection.h>
#include <pcl/manifold/impl/cloud_layout.hpp>
#include <pcl/manifold/impl/cloud_points.hpp>

#include <limits>

template <typename PointT>
void
pcl::DimensionDetection<PointT>::compute (pcl::PointCloud<pcl::Label>& output)
{
  output = pcl::PointCloud<pcl::Label> ();
  result_.reset ();
  const bool done = this->run ("DimensionDetection::compute", [&] (manifold::StageLog& log) {
    return this->withInput ([&] {
      const manifold::Status status = detect (log);
      if (status == manifold::Status::OK)
        giveLabels (output);
      return status;
    });
  });
  if (!done) {
    output = pcl::PointCloud<pcl::Label> ();
    result_.reset ();
  }
}

template <typename PointT>
pcl::manifold::Status
pcl::DimensionDetection<PointT>::detect (manifold::StageLog& log)
{
  manifold::DimensionParameters parameters;
  this->setShared (parameters);
  parameters.rho = rho_;
  return manifold::detectDimensions (manifold::cloudPoints (*input_, *indices_), *indices_,
                                     manifold::FLOAT_RESOLUTION, parameters, log, result_);
}

template <typename PointT>
void
pcl::DimensionDetection<PointT>::giveLabels (pcl::PointCloud<pcl::Label>& output) const
{
  const std::vector<std::int32_t>& sample_of = result_->complex->samples->sample_of;
  output.resize (sample_of.size ());
  for (std::size_t i = 0; i < sample_of.size (); ++i)
    output[i].label = sample_of[i] < 0 ? 0 : result_->dimension[sample_of[i]];
  manifold::copyLayout (*input_, *indices_, output);
}

template <typename PointT>
template <typename T, typename Value>
std::vector<T>
pcl::DimensionDetection<PointT>::perPoint (T none, const Value& value) const
{
  if (!result_)
    return {};
  const std::vector<std::int32_t>& sample_of = result_->complex->samples->sample_of;
  std::vector<T> values (sample_of.size (), none);
  for (std::size_t i = 0; i < sample_of.size (); ++i)
    if (sample_of[i] >= 0)
      values[i] = value (sample_of[i]);
  return values;
}

template <typename PointT>
std::vector<std::uint8_t>
pcl::DimensionDetection<PointT>::getManifoldDimension () const
{
  return perPoint<std::uint8_t> (
    0, [this] (std::int32_t sample) { return result_->manifold_dimension[sample]; });
}

template <typename PointT>
std::vector<std::uint8_t>
pcl::DimensionDetection<PointT>::getBoundary () const
{
  return perPoint<std::uint8_t> (0, [this] (std::int32_t sample) { return result_->boundary[sample]; });
}

template <typename PointT>
std::vector<float>
pcl::DimensionDetection<PointT>::getConfidence () const
{
  return perPoint<float> (0.0f, [this] (std::int32_t sample) { return result_->confidence[sample]; });
}

template <typename PointT>
Eigen::Matrix3Xd
pcl::DimensionDetection<PointT>::getHeights () const
{
  if (!result_)
    return Eigen::Matrix3Xd (3, 0);
  const manifold::SampleSet& samples = *result_->complex->samples;
  Eigen::Matrix3Xd heights (3, static_cast<Eigen::Index> (samples.sample_of.size ()));
  for (std::size_t i = 0; i < samples.sample_of.size (); ++i)
    if (samples.sample_of[i] < 0)
      heights.col (i).setConstant (std::numeric_limits<double>::quiet_NaN ());
    else
      heights.col (i) = result_->heights.col (samples.sample_of[i]) / samples.scale;
  return heights;
}

template <typename PointT>
pcl::Indices
pcl::DimensionDetection<PointT>::getSamples () const
{
  return result_ ? result_->complex->samples->input_index : pcl::Indices ();
}
