#pragma once

#include "../test_must_show_models.h"

#include <functional>
#include <string>
#include <vector>

namespace evaluate {

/** \brief A cloud to be reconstructed, and what has to come out. */
struct Model
{
  std::string name;
  std::function<Eigen::Matrix3Xd ()> points; ///< may throw what readCloud () throws
  must_show::Expected open;                  ///< of the reconstruction as it is by default
  must_show::Expected watertight;
};

/** \brief Clouds whose shape is known.
 * \param[in] seeds number of samples of each shape
 * \param[in] large add those of 10^5 points */
std::vector<Model> generatedModels (int seeds, bool large);

/** \brief The vertices of all meshes and the points of all clouds in a folder, as far as they have at least
 * 1000 points. */
std::vector<Model> modelsOfFolder (const std::string& folder);

} // namespace evaluate
