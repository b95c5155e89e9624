#pragma once

#include <generate/shape.h>

namespace generate {

/** \brief A sphere about the origin. */
Shape sphere (double radius = 1.0);

/** \brief An ellipsoid about the origin. */
Shape ellipsoid (const Eigen::Vector3d& half_axes = {1.0, 0.75, 0.5});

/** \brief The distance of a place of generate::ellipsoid to the medial axis, an elliptic disk. */
double ellipsoidFeatureSize (const Eigen::Vector3d& half_axes, const Eigen::Vector3d& place);

/** \brief A torus about the z axis. */
Shape torus (double big_radius = 1.0, double small_radius = 0.4);

/** \brief The distance of a place of generate::torus to the medial axis, a circle and the z axis. */
double torusFeatureSize (double small_radius, const Eigen::Vector3d& place);

/** \brief A tube about generate::trefoil, a torus that is knotted in space.
 * \param[in] radius below 0.3 * \a scale, or the tube comes too near to itself */
Shape knottedTube (double scale = 1.0, double radius = 0.25);

} // namespace generate
