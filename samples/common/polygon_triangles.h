#pragma once

#include <pcl/PolygonMesh.h>
#include <pcl/manifold/topology_report.h>

namespace pcl::manifold::apps {

/** \brief The polygons of a mesh as triangles, larger ones cut from their first corner. */
pcl::SimplicialComplex trianglesOf (const pcl::PolygonMesh& mesh);

/** \brief The polygons of a mesh as rows. */
FaceRows facesOf (const pcl::PolygonMesh& mesh);

} // namespace pcl::manifold::apps
