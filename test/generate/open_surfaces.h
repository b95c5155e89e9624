#pragma once

#include <generate/shape.h>

namespace generate {

/** Surfaces with boundary. The rim is their stratum. */

/** \brief The half z >= 0 of a sphere about the origin. */
Shape hemisphere (double radius = 1.0);

/** \brief A flat ring in the plane z = 0. */
Shape annulus (double inner_radius = 0.5, double outer_radius = 1.0);

/** \brief A flat square in the plane z = 0, about the origin. */
Shape flatSquare (double side = 2.0);

/** \brief A square of rolling ground about the origin.
 * \param[in] height of the waves; \a side / 20 and below gives gentle slopes
 * The nearest point is found by iteration, right near the surface. */
Shape terrain (double side = 4.0, double height = 0.2);

/** \brief A band with half a twist, about the z axis. */
Shape moebiusBand (double radius = 1.0, double half_width = 0.35);

/** \brief A cylinder about the z axis, without top and bottom, from -height / 2 to height / 2. */
Shape openCylinder (double radius = 0.6, double height = 1.5);

} // namespace generate
