#pragma once

#include <pcl/manifold/scale_dimensions.h>

#include "scales/persistence.h"

#include <vector>

namespace pcl {
namespace manifold {

/** The size and direction of every curve, in the unit of the cloud. */
std::vector<CurveMeasures> measureCurves (const SampleSet& samples, const PersistentLabels& labels);

} // namespace manifold
} // namespace pcl
