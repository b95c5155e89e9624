#pragma once

#include <pcl/manifold/export.h>
#include <pcl/manifold/sample_dimensions.h>
#include <pcl/manifold/sample_set.h>
#include <pcl/manifold/stage_log.h>
#include <pcl/manifold/status.h>

#include <Eigen/Core>

#include <memory>

namespace pcl {
namespace manifold {

/** \brief Parameters of DimensionDetection.
 * \ingroup manifold */
struct DimensionParameters
{
  double rho = 0.3;                                   ///< in (0, 1]
  Thinning thinning;                                  ///< none by default
  unsigned int threads = 0;                           ///< 0 = all cores
  std::shared_ptr<const DelaunayComplex> complex;     ///< of the same points and thinning, or null
  std::shared_ptr<const SampleDimensions> dimensions; ///< likewise: taken over as they are
};

/** \brief DimensionDetection without PCL: from coordinates to the dimensions of the samples.
 * \param[in] points coordinates of the points that the indices name, 3 x n
 * \param[in] indices of the points in the user's cloud, or empty for 0 .. n-1
 * \param[in] resolution relative precision of the coordinates, FLOAT_RESOLUTION for floats
 * \param[in] parameters as the setters of DimensionDetection explain them
 * \param[in,out] log of the stages
 * \param[out] result null unless the answer is Status::OK
 * \return as makeSampleSet, PARAMETER_OUT_OF_RANGE for rho, CANCELLED where the log says so, OUT_OF_MEMORY or
 * INTERNAL_ERROR. Does not throw
 * \ingroup manifold */
PCL_MANIFOLD_DELAUNAY_EXPORTS Status
detectDimensions (const Eigen::Matrix3Xd& points, const pcl::Indices& indices, double resolution,
                  const DimensionParameters& parameters, StageLog& log,
                  std::shared_ptr<const SampleDimensions>& result) noexcept;

} // namespace manifold
} // namespace pcl
