#include <pcl/manifold/topology_report.h>

#include "complex/surface_sides.h"
#include "complex/topology_parts.h"

#include <algorithm>
#include <iterator>

namespace pcl {
namespace manifold {

namespace {

using Edge = SimplicialComplex::Edge;

Edge
edgeOf (pcl::index_t a, pcl::index_t b)
{
  return {std::min (a, b), std::max (a, b)};
}

// The sides of faces, ascending, maybe some more than once.
std::vector<Edge>
sidesOf (const FaceRows& faces)
{
  std::vector<Edge> sides;
  sides.reserve (faces.vertices.size ());
  for (std::size_t f = 0; f < faces.size (); ++f)
    for (std::size_t i = faces.starts[f]; i < faces.starts[f + 1]; ++i)
      sides.push_back (
        edgeOf (faces.vertices[i], faces.vertices[i + 1 < faces.starts[f + 1] ? i + 1 : faces.starts[f]]));
  std::sort (sides.begin (), sides.end ());
  return sides;
}

} // namespace

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

pcl::TopologyReport
analyze (const FaceRows& faces, const std::vector<Edge>& edges)
{
  const std::vector<Edge> sides = sidesOf (faces);
  std::vector<Edge> in_no_face;
  std::copy_if (edges.begin (), edges.end (), std::back_inserter (in_no_face), [&sides] (const Edge& edge) {
    return !std::binary_search (sides.begin (), sides.end (), edgeOf (edge[0], edge[1]));
  });
  pcl::TopologyReport report;
  report.curve = analyzeCurve (in_no_face);
  report.surface = analyzeSurface (faces);
  report.vertices = VertexNumbering ({in_no_face, faces.vertices}).size ();
  return report;
}

} // namespace manifold
} // namespace pcl
