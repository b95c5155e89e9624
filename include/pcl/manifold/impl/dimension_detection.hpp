#pragma once

#include <pcl/impl/pcl_base.hpp> // for point types that PCL does not instantiate itself
#include <pcl/manifold/dimension_detection.h>
#include <pcl/manifold/impl/cloud_layout.hpp>
#include <pcl/manifold/impl/cloud_points.hpp>

#include <limits>

template <typename PointT>
void
pcl::DimensionDetection<PointT>::clear ()
{
  samples_.reset ();
  result_.reset ();
  persistent_.reset ();
}

template <typename PointT>
void
pcl::DimensionDetection<PointT>::compute (pcl::PointCloud<pcl::Label>& output)
{
  output = pcl::PointCloud<pcl::Label> ();
  clear ();
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
    clear ();
  }
}

template <typename PointT>
pcl::manifold::Status
pcl::DimensionDetection<PointT>::detect (manifold::StageLog& log)
{
  manifold::DimensionParameters parameters;
  this->setShared (parameters);
  parameters.rho = rho_;
  const Eigen::Matrix3Xd points = manifold::cloudPoints (*input_, *indices_);
  manifold::Status status;
  if (scales_ == manifold::Scales::OFF) {
    status =
      manifold::detectDimensions (points, *indices_, manifold::FLOAT_RESOLUTION, parameters, log, result_);
    if (status == manifold::Status::OK)
      samples_ = result_->complex->samples;
    return status;
  }
  manifold::ScaleParameters scales = scale_parameters_;
  const Eigen::Vector3d own = input_->sensor_origin_.template head<3> ().template cast<double> ();
  const bool asked = scales.from > 0.0 || scales.to > 0.0;
  if (!scales.sensor_origin && !asked && own.allFinite () && !own.isZero (0.0))
    scales.sensor_origin = own;
  status = manifold::detectScales (points, *indices_, manifold::FLOAT_RESOLUTION, parameters, scales, log,
                                   persistent_);
  if (status == manifold::Status::OK) {
    samples_ = persistent_->samples;
    result_ = persistent_->finest;
  }
  return status;
}

template <typename PointT>
void
pcl::DimensionDetection<PointT>::giveLabels (pcl::PointCloud<pcl::Label>& output) const
{
  const std::vector<std::uint8_t> labels =
    perPoint<std::uint8_t> (0, &manifold::ScaleDimensions::dimension, &manifold::SampleDimensions::dimension);
  output.resize (labels.size ());
  for (std::size_t i = 0; i < labels.size (); ++i)
    output[i].label = labels[i];
  manifold::copyLayout (*input_, *indices_, output);
}

template <typename PointT>
template <typename T, typename Value>
std::vector<T>
pcl::DimensionDetection<PointT>::perPoint (T none, const Value& value) const
{
  if (!samples_)
    return {};
  const std::vector<std::int32_t>& sample_of = samples_->sample_of;
  std::vector<T> values (sample_of.size (), none);
  for (std::size_t i = 0; i < sample_of.size (); ++i)
    if (sample_of[i] >= 0)
      values[i] = value (sample_of[i]);
  return values;
}

template <typename PointT>
template <typename T>
std::vector<T>
pcl::DimensionDetection<PointT>::perPoint (T none, const std::vector<T> manifold::ScaleDimensions::*of_scales,
                                           const std::vector<T> manifold::SampleDimensions::*of_one) const
{
  return perPoint<T> (none, [&] (std::int32_t sample) {
    return persistent_ ? ((*persistent_).*of_scales)[sample] : ((*result_).*of_one)[sample];
  });
}

template <typename PointT>
std::vector<std::uint8_t>
pcl::DimensionDetection<PointT>::getManifoldDimension () const
{
  return perPoint<std::uint8_t> (0, &manifold::ScaleDimensions::manifold_dimension,
                                 &manifold::SampleDimensions::manifold_dimension);
}

template <typename PointT>
std::vector<std::uint8_t>
pcl::DimensionDetection<PointT>::getBoundary () const
{
  return perPoint<std::uint8_t> (0, &manifold::ScaleDimensions::boundary,
                                 &manifold::SampleDimensions::boundary);
}

template <typename PointT>
std::vector<float>
pcl::DimensionDetection<PointT>::getConfidence () const
{
  return perPoint<float> (0.0f, &manifold::ScaleDimensions::confidence,
                          &manifold::SampleDimensions::confidence);
}

template <typename PointT>
std::vector<float>
pcl::DimensionDetection<PointT>::getScale () const
{
  if (!persistent_)
    return {};
  return perPoint<float> (0.0f, [this] (std::int32_t sample) { return persistent_->scale[sample]; });
}

template <typename PointT>
std::vector<float>
pcl::DimensionDetection<PointT>::getPersistence () const
{
  if (!persistent_)
    return {};
  return perPoint<float> (0.0f, [this] (std::int32_t sample) { return persistent_->persistence[sample]; });
}

template <typename PointT>
std::vector<std::int32_t>
pcl::DimensionDetection<PointT>::getCurveOfPoint () const
{
  if (!persistent_)
    return {};
  return perPoint<std::int32_t> (-1, [this] (std::int32_t sample) { return persistent_->curve[sample]; });
}

template <typename PointT>
Eigen::Matrix3Xf
pcl::DimensionDetection<PointT>::getTangents () const
{
  if (!persistent_)
    return Eigen::Matrix3Xf (3, 0);
  const std::vector<std::int32_t>& sample_of = samples_->sample_of;
  Eigen::Matrix3Xf tangents = Eigen::Matrix3Xf::Zero (3, static_cast<Eigen::Index> (sample_of.size ()));
  for (std::size_t i = 0; i < sample_of.size (); ++i)
    if (sample_of[i] >= 0)
      tangents.col (static_cast<Eigen::Index> (i)) = persistent_->tangents.col (sample_of[i]);
  return tangents;
}

template <typename PointT>
Eigen::Matrix3Xd
pcl::DimensionDetection<PointT>::getHeights () const
{
  if (!result_)
    return Eigen::Matrix3Xd (3, 0);
  Eigen::Matrix3Xd heights (3, static_cast<Eigen::Index> (samples_->sample_of.size ()));
  for (std::size_t i = 0; i < samples_->sample_of.size (); ++i)
    if (samples_->sample_of[i] < 0)
      heights.col (i).setConstant (std::numeric_limits<double>::quiet_NaN ());
    else
      heights.col (i) = result_->heights.col (samples_->sample_of[i]) / samples_->scale;
  return heights;
}

template <typename PointT>
pcl::Indices
pcl::DimensionDetection<PointT>::getSamples () const
{
  return samples_ ? samples_->input_index : pcl::Indices ();
}
