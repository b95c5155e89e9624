#pragma once

#include <generate/labelled_cloud.h>
#include <generate/shape.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace generate {

/** \brief The shapes of the mixed scene, at least 1 apart from each other: a sphere of radius 1, a torus of
 * radii 1 and 0.4, a trefoil knot of feature size 0.45 and a solid ball of radius 0.6. */
std::vector<Shape> mixedSceneShapes ();

/** \brief Blue noise on all shapes of the mixed scene. `object` is the index of the shape.
 * \param[in] spacing up to 0.12 makes every shape a dense sample
 * \param[in] tick told how far it is; may be empty */
LabelledCloud mixedScene (double spacing, std::uint64_t seed, const Tick& tick = {});

/** \brief The mixed scene sampled at random: \a sphere_points on the sphere, as many per area on the torus,
 * as many per length on the knot as that is along a line, and as many in the ball as on the sphere.
 * \param[in] sphere_points 60 000 is the customary number */
LabelledCloud mixedSceneRandom (std::size_t sphere_points, std::uint64_t seed);

} // namespace generate
