#pragma once

#include <pcl/manifold/impl/cloud_points.hpp>
#include <pcl/manifold/status.h>
#include <pcl/pcl_base.h>

#include <cstddef>
#include <cstdint>
#include <limits>

namespace pcl {
namespace manifold {

/** \brief Runs a computation on the input of a PCL class, unless there is none or an index names no point.
 * \param[in] input the class's input_, may be null
 * \param[in] indices the class's indices_, looked at after \a init
 * \param[in] init, deinit its initCompute () and deinitCompute ()
 * \param[in] compute answers with a status
 * \return NO_INPUT, TOO_MANY_POINTS, PARAMETER_OUT_OF_RANGE, or what \a compute answers */
template <typename PointT, typename Init, typename Deinit, typename Compute>
Status
onGuardedInput (const typename pcl::PCLBase<PointT>::PointCloudConstPtr& input,
                const pcl::IndicesPtr& indices, const Init& init, const Deinit& deinit,
                const Compute& compute)
{
  // The base class would number the points with indices that overflow.
  if (input && input->size () > static_cast<std::size_t> (std::numeric_limits<std::int32_t>::max ()))
    return Status::TOO_MANY_POINTS;
  // PCL's initCompute () takes an empty cloud, and refuses indices of it.
  if (!input || !init ())
    return Status::NO_INPUT;
  const Status status = areValid (*input, *indices) ? compute () : Status::PARAMETER_OUT_OF_RANGE;
  deinit ();
  return status;
}

} // namespace manifold
} // namespace pcl
