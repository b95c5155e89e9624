#pragma once

#include <generate/ray_scene.h>

#include <cstdint>

namespace generate {

/** \brief Classes of things in a lidar scene, with the numbers that the LAS file format gives to them; those from
 * 64 on are for the user to define there. */
enum class LidarClass : std::uint32_t
{
  GROUND = 2,
  VEGETATION = 5, ///< trunks (label 2) and leaves (label 3)
  BUILDING = 6,
  ROAD = 11, ///< with its kerbs and pavements
  WIRE = 14,
  POLE = 15,  ///< poles, lamp posts, pylons and their arms (label 1)
  FENCE = 64, ///< posts and wires (label 1)
  SIGN = 65,  ///< the plates (label 2)
  CAR = 66
};

/** \brief Half the size of the village along x and y, in metres. */
constexpr double VILLAGE_HALF_LENGTH = 60.0;
constexpr double VILLAGE_HALF_WIDTH = 40.0;

/** \brief Height of the rolling ground of the village. */
double villageGround (double x, double y);

/** \brief A place to live, in metres: rolling ground, houses with gable roofs, trees, lamp posts, a power
 * line on poles along x and a high one on pylons along y. Ready for rays.
 * \param[in] beam_radius as for RayScene
 * \param[in] seed where the trees stand and how their leaves hang */
RayScene village (double beam_radius, std::uint64_t seed);

} // namespace generate
