#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace evaluate {

/** \brief What the truth asks of a point. */
enum class Curve : std::uint8_t
{
  NO,
  YES,
  NOT_ASKED ///< either answer will do, or the point is too far away
};

/** \brief Points whose dimension is known, or at least which of them are those of curves. */
struct LabelledPoints
{
  Eigen::Matrix3Xd points;
  std::vector<Curve> curve;
  std::vector<std::uint8_t> dimension; ///< empty where only the curves are known
  std::vector<std::uint32_t> classes;  ///< of things, as the cloud numbers them
};

struct DimensionCloud
{
  std::string name;
  std::function<LabelledPoints ()> make; ///< may throw what readCloud () throws
  bool vertical = false;                 ///< whether the true curves are upright
};

/** \brief Scenes and sweeps that are generated: `seeds` of each. */
std::vector<DimensionCloud> generatedClouds (int seeds);

/** \brief The real clouds with labels. Those that are not in the folder are left out with a line on standard
 * output. */
std::vector<DimensionCloud> labelledFiles (const std::string& folder);

} // namespace evaluate
