#pragma once

#include <pcl/manifold/topology_report.h>

#include <vector>

namespace pcl {
namespace manifold {

CurveTopology analyzeCurve (const std::vector<SimplicialComplex::Edge>& edges);

SurfaceTopology analyzeSurface (const FaceRows& faces);

SolidTopology analyzeSolid (const std::vector<SimplicialComplex::Tetrahedron>& tetrahedra);

} // namespace manifold
} // namespace pcl
