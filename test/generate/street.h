#pragma once

#include <generate/ray_scene.h>

#include <cstdint>

namespace generate {

/** \brief Half the length of the street, along x, in metres. */
constexpr double STREET_HALF_LENGTH = 110.0;

/** \brief Half the width of its road, and where its kerbs and pavements end and the front gardens begin. */
constexpr double ROAD_HALF_WIDTH = 3.5;
constexpr double PAVEMENT_END = 6.5;

/** \brief Height of the ground of the street above or below that of the middle of its road. */
double streetGround (double y);

/** \brief A street in a town, in metres, along x: a road between kerbs and pavements, houses behind front
 * gardens with wire fences, parked cars, lamp posts with arms, signs on poles, trees, and cables on wooden
 * poles, from there to the houses too. Ready for rays.
 * \param[in] beam_radius as for RayScene
 * \param[in] seed where houses, cars, signs and trees stand */
RayScene street (double beam_radius, std::uint64_t seed);

} // namespace generate
