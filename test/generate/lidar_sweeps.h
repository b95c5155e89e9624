#pragma once

#include <generate/lidar.h>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace generate {

/** \brief A lidar under a name that a user can type. */
struct LidarSweep
{
  std::string name;
  std::function<LabelledCloud (const LidarSettings&, const Tick&)> make;
  std::size_t usual_points; ///< 0: as many as the sensor makes
};

/** \brief All of them: lidar-aerial, lidar-terrestrial, frame-16, frame-32, frame-64, map-64. */
const std::vector<LidarSweep>& lidarSweeps ();

} // namespace generate
