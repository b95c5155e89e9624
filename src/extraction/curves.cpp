#include "extraction/curves.h"

#include "common/parallel.h"
#include "voronoi/cocone.h"

#include <algorithm>
#include <utility>

namespace pcl {
namespace manifold {

namespace {

using Edge = std::array<std::int32_t, 2>;

// Candidate edges between curve samples with their squared lengths, shortest first, each once.
std::vector<std::pair<double, Edge>>
candidateEdges (const SampleDimensions& dimensions, const std::vector<Role>& roles)
{
  const DelaunayComplex& complex = *dimensions.complex;
  std::vector<std::vector<std::int32_t>> neighbors (roles.size ());
  parallelFor (roles.size (), [&] (std::size_t i) {
    if (roles[i] == Role::CURVE && dimensions.dimension[i] == 1)
      neighbors[i] = coconeNeighbors (complex, VoronoiCell (complex, static_cast<std::int32_t> (i)),
                                      dimensions.tangents.col (i));
  });
  std::vector<std::pair<double, Edge>> edges;
  for (std::size_t i = 0; i < neighbors.size (); ++i)
    for (const std::int32_t q : neighbors[i])
      if (roles[q] == Role::CURVE) {
        const auto p = static_cast<std::int32_t> (i);
        const double length =
          (complex.samples->points.col (p) - complex.samples->points.col (q)).squaredNorm ();
        edges.push_back ({length, {std::min (p, q), std::max (p, q)}});
      }
  std::sort (edges.begin (), edges.end ());
  edges.erase (std::unique (edges.begin (), edges.end ()), edges.end ());
  return edges;
}

bool
isSide (const Edge& edge, const FacetSet& surface, const std::vector<std::uint8_t>& solid)
{
  const DelaunayComplex& complex = surface.complex ();
  bool side = false;
  surface.forEachAt (edge[0], [&] (std::int32_t cell, int facet) {
    for (const std::int32_t vertex : oppositeSide (complex, cell, facet, edge[0]))
      side = side || vertex == edge[1];
  });
  for (const std::int32_t cell : VoronoiCell (complex, edge[0]))
    side = side || (solid[cell] && std::find (complex.cells[cell].begin (), complex.cells[cell].end (),
                                              edge[1]) != complex.cells[cell].end ());
  return side;
}

} // namespace

std::vector<Edge>
extractCurves (const SampleDimensions& dimensions, const std::vector<Role>& roles, const FacetSet& surface,
               const std::vector<std::uint8_t>& solid)
{
  const Eigen::Matrix3Xd& points = dimensions.complex->samples->points;
  std::vector<Edge> curves;
  std::vector<std::array<std::int32_t, 2>> linked (roles.size (), {-1, -1});
  const auto accepts = [&] (std::int32_t p, std::int32_t q) {
    return linked[p][1] < 0 &&
           (linked[p][0] < 0 ||
            (points.col (linked[p][0]) - points.col (p)).dot (points.col (q) - points.col (p)) < 0.0);
  };
  const auto link = [&] (std::int32_t p, std::int32_t q) { linked[p][linked[p][0] < 0 ? 0 : 1] = q; };
  for (const auto& candidate : candidateEdges (dimensions, roles)) {
    const Edge& edge = candidate.second;
    if (!accepts (edge[0], edge[1]) || !accepts (edge[1], edge[0]) || isSide (edge, surface, solid))
      continue;
    link (edge[0], edge[1]);
    link (edge[1], edge[0]);
    curves.push_back (edge);
  }
  return curves;
}

} // namespace manifold
} // namespace pcl
