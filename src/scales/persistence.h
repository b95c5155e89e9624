#pragma once

#include <pcl/types.h>

#include "scales/level_evidence.h"
#include "scales/scale_ladder.h"
#include "scales/sensor_coordinates.h"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl {
namespace manifold {

/** The answer for every point of the first level of a ladder. */
struct PersistentLabels
{
  std::vector<std::uint8_t> manifold_dimension; ///< the label that persists
  std::vector<std::uint8_t> dimension;          ///< as published, of the level from which on it does
  std::vector<std::uint8_t> boundary;           ///< of that level
  std::vector<float> confidence;                ///< the mean of the levels on which it persists, in [0, 1]
  std::vector<float> scale;                     ///< the spacing of the level from which on it does
  std::vector<float> persistence;               ///< octaves over which it does
  Eigen::Matrix3Xf tangent;                     ///< unit vectors along curves, elsewhere 0
  std::vector<float> offset;                    ///< of points of curves: how far from the axis; elsewhere 0
  std::vector<std::int32_t> curve;              ///< the number of the point's curve, or -1
  std::int32_t curves = 0;
};

/** Chooses for every point the label that persists over the scales.
 *
 * A run is a sequence of consecutive levels that say the same of a point. A level speaks for a curve where
 * the point belongs to a piece of one, by the logarithm of its length in spacings (octaves again), or where
 * it and most of its neighbours are labelled so, by one; a run that gathers five octaves makes the point one
 * of a curve. Else the run with the largest sum of confidences decides between surface and solid; the samples
 * of a surface must lie near a plane, for the coarsest levels of a solid are a handful of samples that any
 * label fits. Pieces of different levels that share points of curves are one curve.
 * \param[in] levels of the ladder; levels and evidence that were left out at the fine end are empty there
 * \param[in] evidence of each
 * \param[in] neighbors NEAREST a point of the first level, of which seven outvote one in whether it is of a surface or
 * a solid; or none */
PersistentLabels choosePersistent (const std::vector<ScaleLevel>& levels,
                                   const std::vector<LevelEvidence>& evidence,
                                   const std::vector<pcl::index_t>& neighbors);

/** Takes scales, offsets and tangents that were found in coordinates of the sensor back to space.
 * \param[in] points in space, as the labels */
void toSpace (const SensorCoordinates& sensor, const Eigen::Matrix3Xd& points, PersistentLabels& labels);

} // namespace manifold
} // namespace pcl
