#pragma once

#include "report.h"
#include "table.h"

#include <pcl/manifold/topology_report.h>

namespace pcl::manifold::apps {

Json::Value surfaceJson (const SurfaceTopology& surface);

/** \brief Reports and tabulates the topology of a complex, and says it in words.
 * \param[in] samples that it is over; 0: it is over some of them on purpose */
void describeTopology (const pcl::TopologyReport& topology, std::size_t samples, Report& report,
                       Table& table);

} // namespace pcl::manifold::apps
