#pragma once

#include "dimension_methods.h"

namespace evaluate {

/** \brief The features of the eigenvalues of each point's neighbours, at the one of several numbers of neighbours
 * that gives them the least entropy: of linearity, planarity and scattering the largest is the answer
 * (Demantké, Mallet, David, Vallet, "Dimensionality based scale selection in 3D lidar point clouds", 2011).
 */
Answers pcaOfLeastEntropy (const Eigen::Matrix3Xd& points);

/** \brief What linearity within one radius finds, radius and threshold chosen with hindsight. */
struct TunedPca
{
  double radius = 0.0, linearity = 0.0;
  CurveScore score; ///< of 30 000 points that are spread over the cloud
};

TunedPca tunePca (const LabelledPoints& truth, double spacing);

} // namespace evaluate
