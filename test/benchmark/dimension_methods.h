#pragma once

#include "dimension_clouds.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace evaluate {

/** \brief What a method says of every point. */
struct Answers
{
  std::vector<std::uint8_t> dimension; ///< 1, 2, 3; empty if there is none
  std::vector<std::uint8_t> upright;   ///< whether it is of an upright curve; empty if the method cannot tell
  double seconds = 0.0;
};

/** \brief How well curves are found. */
struct CurveScore
{
  std::size_t hits = 0, false_alarms = 0, misses = 0, rejections = 0;

  void count (Curve truth, bool found);

  double accuracy () const;
  double precision () const;
  double recall () const;
  double f1 () const;
};

/** \param[in] upright take only upright curves for found ones */
CurveScore scoreOf (const LabelledPoints& truth, const Answers& answers, bool upright = false);

/** \brief The median distance from a point to the nearest other one. */
double medianSpacing (const Eigen::Matrix3Xd& points);

/** \brief DimensionDetection with nothing set. */
Answers detectAtAllScales (const Eigen::Matrix3Xd& points, unsigned int threads);

/** \brief What DimensionDetection says at one level: the label as published, which takes rims for curves, and that
 * of the manifold. */
struct LevelAnswers
{
  Answers published, manifold;
};

/** \param[in] thin_distance as of setThinningDistance (), 0 = of the points themselves */
LevelAnswers detectAtOneLevel (const Eigen::Matrix3Xd& points, double thin_distance, unsigned int threads);

} // namespace evaluate
