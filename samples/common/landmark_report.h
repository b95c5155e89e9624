#pragma once

#include "report.h"
#include "table.h"

#include <pcl/manifold/graph_faces.h>

namespace pcl::manifold::apps {

/** \brief Reports and tabulates the topology of a mesh of landmarks, as section 4.3 of the paper counts it.
 */
void describeLandmarks (const LandmarkMeshReport& mesh, Report& report, Table& table);

/** \brief A genus as a reader expects it: 3, or 3.5 where it is no whole number. */
std::string genusText (double genus);

} // namespace pcl::manifold::apps
