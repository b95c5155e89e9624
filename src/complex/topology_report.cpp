#include <pcl/manifold/topology_report.h>

#include "complex/surface_sides.h"
#include "complex/topology_parts.h"

namespace pcl {
namespace manifold {

pcl::TopologyReport
analyze (const SimplicialComplex& complex)
{
  pcl::TopologyReport report;
  report.vertices = VertexNumbering ({complex.edges, complex.triangles, complex.tetrahedra}).size ();
  report.curve = analyzeCurve (complex.edges);
  report.surface = analyzeSurface (toFaceRows (complex.triangles));
  report.solid = analyzeSolid (complex.tetrahedra);
  return report;
}

} // namespace manifold
} // namespace pcl
