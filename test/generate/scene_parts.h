#pragma once

#include <generate/random.h>
#include <generate/ray_scene.h>
#include <generate/village.h>

#include <cstdint>

// What villages and streets are made of, in metres.
namespace generate {

inline Truth
truth (std::uint32_t label, LidarClass thing)
{
  return {label, static_cast<std::uint32_t> (thing)};
}

/** \brief A flat patch with four corners, given around it. */
void addQuad (RayScene& scene, const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
              const Eigen::Vector3d& d, Truth what);

/** \brief A wire between two points, hanging through by `sag` in its middle. Between points of about the same
 * height the catenary is a parabola to within a thousandth of its sag. */
void addWire (RayScene& scene, const Eigen::Vector3d& from, const Eigen::Vector3d& to, double sag);

/** \brief A house with a gable roof that juts out over its walls.
 * \param[in] foot the middle of its floor
 * \param[in] angle of its length against x
 * \param[in] eaves height of its walls
 * \param[in] ridge height of its roof */
void addHouse (RayScene& scene, const Eigen::Vector3d& foot, double angle, double length, double width,
               double eaves, double ridge);

/** \brief Between which half extents the crown of a tree is chosen. */
struct TreeSize
{
  Eigen::Vector3d smallest, largest;
};

/** \brief A trunk (label 2) in a crown of loose leaves (label 3). */
void addTree (RayScene& scene, const Eigen::Vector3d& foot, const TreeSize& size, Random& random);

} // namespace generate
