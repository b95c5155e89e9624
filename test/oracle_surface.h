#pragma once

#include "oracle_lattice.h"

#include "extraction/facet_set.h"
#include "extraction/sample_roles.h"
#include "voronoi/dimension.h"

#include <pcl/manifold/topology_report.h>

#include <algorithm>
#include <vector>

namespace oracle {

/** \brief What the stages of the extraction work on. */
struct Prepared
{
  std::shared_ptr<const pcl::manifold::DelaunayComplex> complex;
  pcl::manifold::SampleDimensions dimensions;
  std::vector<pcl::manifold::Role> roles;
};

inline Prepared
prepare (const Eigen::Matrix3Xd& cloud)
{
  Prepared result;
  result.complex = complexOf (cloud);
  result.dimensions = pcl::manifold::computeDimensions (result.complex, 0.3);
  pcl::manifold::decideManifoldDimensions (result.dimensions);
  result.roles = pcl::manifold::sampleRoles (result.dimensions);
  return result;
}

/** \brief The topology of a set of triangles, by the report. */
inline pcl::manifold::SurfaceTopology
topologyOf (const pcl::manifold::FacetSet& surface)
{
  pcl::SimplicialComplex shape;
  for (const auto& triangle : surface.triangles ([] (std::int32_t) { return false; }))
    shape.triangles.push_back ({triangle[0], triangle[1], triangle[2]});
  return pcl::manifold::analyze (shape).surface;
}

/** \brief All facets without the infinite vertex, each from its cell with the smaller number. */
inline std::vector<pcl::manifold::Facet>
finiteFacets (const pcl::manifold::DelaunayComplex& complex)
{
  std::vector<pcl::manifold::Facet> facets;
  for (std::size_t i = 0; i < complex.cells.size (); ++i)
    for (int k = 0; k < 4; ++k) {
      const auto cell = static_cast<std::int32_t> (i);
      const std::array<std::int32_t, 3> triangle = pcl::manifold::facetOf (complex, cell, k);
      if (cell < complex.neighbors[i][static_cast<std::size_t> (k)] &&
          *std::min_element (triangle.begin (), triangle.end ()) >= 0)
        facets.push_back ({cell, k});
    }
  return facets;
}

/** \brief Colours with the infinite cells 0: random ones, or balls, or both. */
inline std::vector<std::uint8_t>
randomColors (const pcl::manifold::DelaunayComplex& complex, Random& random)
{
  const int balls = random.index (3);
  const double noise = random.index (4) == 0 ? 0.0 : 0.5 * random.uniform ();
  const Eigen::Matrix3Xd& points = complex.samples->points;
  const double size = (points.rowwise ().maxCoeff () - points.rowwise ().minCoeff ()).norm ();
  std::vector<Eigen::Vector3d> centers;
  for (int ball = 0; ball < balls; ++ball)
    centers.emplace_back (points.col (random.index (static_cast<int> (points.cols ()))));
  const double radius = size * random.uniform () * 0.6;
  std::vector<std::uint8_t> colors (complex.cells.size (), 0);
  for (std::int32_t cell = 0; cell < complex.finite_cells; ++cell) {
    bool inside = false;
    for (const Eigen::Vector3d& center : centers)
      inside = inside || (complex.centers.col (cell) - center).norm () < radius;
    colors[static_cast<std::size_t> (cell)] = inside != (random.uniform () < noise) ? 1 : 0;
  }
  return colors;
}

} // namespace oracle
