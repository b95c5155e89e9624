#pragma once

#include <generate/shape.h>

namespace generate {

/** Solids. The skin is their stratum: a closed surface of class "dimension 2" on its own, but part of the
 * solid, and labelled 3, when it is sampled with it. */

/** \brief A ball about the origin. */
Shape ball (double radius = 1.0);

/** \brief A box about the origin with edges along the axes. The edges and corners of its skin are strata. */
Shape box (const Eigen::Vector3d& size = {2.0, 1.6, 1.2});

/** \brief A solid torus about the z axis. */
Shape solidTorus (double big_radius = 1.0, double small_radius = 0.4);

} // namespace generate
