#pragma once

#include <pcl/manifold/fixed_point_complex.h>

#include "extraction/facet_set.h"
#include "voronoi/subpolytopes.h"

#include <cstdint>
#include <vector>

namespace pcl {
namespace manifold {

/** The two poles of a sample (section 7 of Khoury and Shewchuk), on either side of the surface; one with the
 * height infinite is at infinity. */
struct Poles
{
  Pole positive; ///< the vertex of the Voronoi cell farthest from the sample
  Pole negative; ///< the farthest one among those at more than 90 degrees to the positive pole
};

/** Where the cell is unbounded on the negative side, too, as it is where the samples are of a sheet, the
 * negative pole is at infinity. */
Poles computePoles (const VoronoiCell& cell);

/** |vz| / |vp| for a sample v, and the pole p that a critical point z is compared with: the negative one
 * where the cell is unbounded, or else the one nearest to the direction of z. 0 for a pole at infinity.
 * \param[in] critical z - v */
double poleRatio (const Poles& poles, const Eigen::Vector3d& critical);

/** Whether each anchored triangle is medial. Parallel in the current arena. */
std::vector<std::uint8_t> findMedial (const DelaunayComplex& complex, const std::vector<Facet>& anchored,
                                      const CriticalPointParameters& parameters);

} // namespace manifold
} // namespace pcl
