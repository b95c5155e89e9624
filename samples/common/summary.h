#pragma once

#include <pcl/manifold/topology_report.h>

#include <string>
#include <vector>

namespace pcl::manifold::apps {

/** \brief What became of the points of a cloud. */
struct PointCounts
{
  std::size_t points = 0;         ///< of the file
  std::size_t dropped = 0;        ///< not finite
  std::size_t no_measurement = 0; ///< stored at one place, most often (0, 0, 0), by the sensor's driver
  std::size_t duplicates = 0;     ///< of other points
  std::size_t thinned = 0;        ///< left out by thinning
  std::size_t samples = 0;        ///< all others
};

/** \brief How many points there are, how many were left out, and why. */
std::string inWords (const PointCounts& counts);

/** \brief How many parts a surface has, whether they are closed, one-sided and manifold; nothing for none.
 * \param[in] name of the surface, at the beginning of sentences */
std::vector<std::string> inWords (const std::string& name, const SurfaceTopology& surface);

/** \brief The same for curves, the surface and solids. */
std::vector<std::string> inWords (const pcl::TopologyReport& topology);

} // namespace pcl::manifold::apps
