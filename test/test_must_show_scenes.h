#pragma once

#include "test_must_show_models.h"

#include <generate/labelled_cloud.h>

#include <pcl/manifold/detect_dimensions.h>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace must_show {

/** \brief How many points of a labelled cloud got their true dimension. */
struct DimensionScore
{
  std::size_t asked = 0; ///< all of curves and surfaces, and those of solids that are deep enough
  std::size_t right = 0;

  double share () const
  {
    return asked == 0 ? 0.0 : static_cast<double> (right) / static_cast<double> (asked);
  }
};

/** \brief Detects the published dimension of every point.
 * \param[in] min_depth points of solids are asked if they lie deeper than this: the skin is labelled 2
 * \param[in] neighbors thinning, 0 = off */
inline DimensionScore
scoreDimensions (const generate::LabelledCloud& cloud, double min_depth, int neighbors)
{
  pcl::manifold::DimensionParameters parameters;
  parameters.thinning.neighbors = neighbors;
  pcl::manifold::StageLog log;
  std::shared_ptr<const pcl::manifold::SampleDimensions> dimensions;
  DimensionScore score;
  if (pcl::manifold::detectDimensions (pointsOf (cloud), {}, pcl::manifold::FLOAT_RESOLUTION, parameters, log,
                                       dimensions) != pcl::manifold::Status::OK)
    return score;
  const std::vector<std::int32_t>& sample_of = dimensions->complex->samples->sample_of;
  for (std::size_t i = 0; i < cloud.size (); ++i)
    if (cloud.labels[i] < 3 || cloud.depth[i] > min_depth) {
      ++score.asked;
      score.right += dimensions->dimension[sample_of[i]] == cloud.labels[i] ? 1 : 0;
    }
  return score;
}

/** \brief The distance to the k-th neighbour inside of the ball of the mixed scene, whose radius is 0.6,
 * where points are random: the spacing that is left after thinning. */
inline double
ballSpacing (std::size_t ball_points, int k)
{
  return 0.6 * std::cbrt (static_cast<double> (k) / static_cast<double> (ball_points));
}

} // namespace must_show
