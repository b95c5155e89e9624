#pragma once

#include "scene.h"

#include <array>
#include <vector>

namespace pcl::manifold::apps {

/** \brief How a scene is looked at: from obliquely above, z up, in parallel projection. */
struct View
{
  std::array<double, 3> towards{0, 0, -1}; ///< direction of view, of unit length
  std::array<double, 3> right{1, 0, 0};
  std::array<double, 3> up{0, 1, 0};
  std::array<double, 3> centre{0, 0, 0}; ///< what is in the middle of the picture
  double half_height = 1;                ///< distance from the middle to the upper edge
};

/** \brief The finite corners of a scene, without repeats in a layer. */
std::vector<std::array<double, 3>> cornersOf (const std::vector<Panel>& panels);

/** \brief Of some oblique directions, the one from which the corners cover most of the picture, so placed
 * that all of them are within it.
 * \param[in] corners finite points, of coordinates no larger than about 1; none: some view
 * \param[in] aspect width of a panel over its height */
View chooseView (const std::vector<std::array<double, 3>>& corners, double aspect);

} // namespace pcl::manifold::apps
