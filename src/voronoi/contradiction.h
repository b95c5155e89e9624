#pragma once

#include <pcl/manifold/sample_dimensions.h>

#include "voronoi/voronoi_cell.h"

#include <cstdint>
#include <vector>

namespace pcl {
namespace manifold {

/** Whether what is around a sample of a curve says that it is none: more than a quarter of its nearest
 * samples are beside the curve, at more than 45 degrees, or there are others beside it, not twelve times as
 * far away as those along it, and none above and below it, as where the points of a surface lie in rows.
 * \param[in] nearest a few samples, the nearest ones */
bool isContradicted (const SampleDimensions& dimensions, const VoronoiCell& cell,
                     const std::vector<std::int32_t>& nearest);

} // namespace manifold
} // namespace pcl
