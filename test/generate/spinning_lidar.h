#pragma once

#include <generate/labelled_cloud.h>
#include <generate/lidar.h>
#include <generate/shape.h>

#include <vector>

namespace generate {

/** \brief A lidar that turns around z with lasers one above the other: every one draws a ring. */
struct SpinningLidar
{
  std::vector<double> elevations; ///< of the lasers in radians, ascending
  double step;                    ///< by how much it turns between two pulses of a laser, in radians
};

/** \brief Sensors as they are on cars and robots, with the elevations and the step of the VLP-16, HDL-32 and
 * HDL-64.
 * \param[in] rings 16, 32 or 64
 * \throws std::invalid_argument for others */
SpinningLidar spinningLidar (int rings);

/** \brief One turn of the sensor over generate::street, seen from the sensor: it is at 0 0 0, 1.73 m above the
 * road, x along the street. `label` and `object` are as of the other sweeps. Where a pulse meets nothing
 * within 80 m there is no point, and two of a hundred are lost. Points come column by column.
 * \param[in] rings as for spinningLidar ()
 * \param[in] settings here 0 points stand for the step of the sensor
 * \throws std::invalid_argument if a setting is out of its range */
LabelledCloud lidarFrame (int rings, const LidarSettings& settings, const Tick& tick = {});

/** \brief 16 such frames from a drive of 15 m, in coordinates of the first, each with a pose that is wrong by 2 cm
 * and 0.05 degrees (standard deviations of every coordinate). */
LabelledCloud lidarMap (int rings, const LidarSettings& settings, const Tick& tick = {});

} // namespace generate
