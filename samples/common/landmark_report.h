#pragma once

#include "report.h"
#include "table.h"

#include <pcl/manifold/topology_report.h>

#include <cstddef>

namespace pcl::manifold::apps {

/** \brief Reports and tabulates the topology of a mesh of landmarks before it was cut into triangles. */
void describeLandmarks (std::size_t landmarks, const pcl::TopologyReport& mesh, Report& report, Table& table);

} // namespace pcl::manifold::apps
