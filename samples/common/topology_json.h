#pragma once

#include "report.h"
#include "table.h"

#include <pcl/manifold/topology_report.h>

namespace pcl::manifold::apps {

Json::Value surfaceJson (const SurfaceTopology& surface);

/** \brief Reports and tabulates the topology of a complex. */
void describeTopology (const pcl::TopologyReport& topology, Report& report, Table& table);

/** \brief Tells the user on standard error where a mesh is no manifold. */
void noteNonManifold (const std::string& file, const SurfaceTopology& surface, bool quiet);

} // namespace pcl::manifold::apps
