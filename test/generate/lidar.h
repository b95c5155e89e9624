#pragma once

#include <generate/labelled_cloud.h>
#include <generate/shape.h>
#include <generate/village.h>

#include <cstddef>
#include <cstdint>

namespace generate {

struct LidarSettings
{
  std::size_t points = 200000; ///< about how many are wanted, positive; the angular steps follow from it
  double range_noise = 0.02;   ///< standard deviation of the measured distance in metres, 0 or more
  std::uint64_t seed = 1;
};

/** Simulated lidar sweeps over generate::village. Light that meets something does not reach what is behind:
 * only leaves and wires let a part of it pass. `label` is the manifold dimension of what was hit (1 wires,
 * poles, posts and struts; 2 ground, houses, trunks; 3 foliage), `object` its LidarClass. In metres.
 * `tick`, if not empty, is told how far it is.
 * \throws std::invalid_argument if a setting is out of its range */

/** \brief From an aircraft 100 m above: two strips, one looking a little forward and one back, up to four
 * returns for a pulse. Points come strip by strip, line by line. */
LabelledCloud lidarAerial (const LidarSettings& settings = {}, const Tick& tick = {});

/** \brief From two tripods in the street, one return for a pulse, dense near them and sparse far away. Points
 * come tripod by tripod, column by column. */
LabelledCloud lidarTerrestrial (const LidarSettings& settings = {}, const Tick& tick = {});

} // namespace generate
