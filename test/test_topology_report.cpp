// The report as a whole, curves and solids. Surfaces: test_topology_surfaces.
#include "test_topology_clouds.h"

#include <limits>

namespace {

using namespace topology;

TEST (TopologyReport, Empty)
{
  const pcl::TopologyReport report = analyze (SimplicialComplex ());
  EXPECT_EQ (0u, report.vertices);
  EXPECT_EQ (0u, report.curve.edges);
  EXPECT_TRUE (report.curve.components.empty ());
  EXPECT_EQ (0u, report.surface.faces);
  EXPECT_TRUE (report.surface.components.empty ());
  EXPECT_TRUE (report.surface.isClosed ());
  EXPECT_TRUE (report.surface.isManifold ());
  EXPECT_EQ (0u, report.solid.tetrahedra);
  EXPECT_TRUE (report.solid.components.empty ());
  EXPECT_EQ (0u, report.solid.boundary.faces);
}

TEST (TopologyReport, DegenerateSimplicesAreCountedAndLeftOut)
{
  SimplicialComplex complex;
  complex.edges = {{3, 3}, {-1, 2}, {0, 1}};
  complex.triangles = {{0, 1, 1}, {-4, 1, 2}, {5, 6, 7}};
  complex.tetrahedra = {{0, 1, 2, 0}, {0, 1, 2, -1}, {8, 9, 10, 11}};
  const pcl::TopologyReport report = analyze (complex);
  EXPECT_EQ (2u, report.curve.degenerate_edges);
  EXPECT_EQ (1u, report.curve.edges);
  EXPECT_EQ (2u, report.surface.degenerate_faces);
  EXPECT_EQ (1u, report.surface.faces);
  EXPECT_EQ (3u, report.surface.vertices);
  EXPECT_EQ (2u, report.solid.degenerate_tetrahedra);
  EXPECT_EQ (1u, report.solid.tetrahedra);
}

FaceRows
rowsOf (const std::vector<pcl::Indices>& faces)
{
  FaceRows rows;
  for (const pcl::Indices& face : faces) {
    rows.vertices.insert (rows.vertices.end (), face.begin (), face.end ());
    rows.starts.push_back (rows.vertices.size ());
  }
  return rows;
}

TEST (TopologyReport, DegenerateRows)
{
  const SurfaceTopology surface = surfaceOfRows (
    rowsOf ({{}, {1}, {1, 2}, {0, 1, 2}, {0, 1, 2, 1}, {3, 3, 4, 5}, {6, 7, 8, 7, 6, 9}, {-1, 1, 2}}));
  EXPECT_EQ (7u, surface.degenerate_faces);
  EXPECT_EQ (1u, surface.faces);
}

// Two triangles that touch at 0 are bounded from outside by one face, which passes 0 twice.
TEST (TopologyReport, FacesMayPassAVertexTwice)
{
  const SurfaceTopology surface = surfaceOfRows (rowsOf ({{0, 1, 2}, {0, 3, 4}, {0, 4, 3, 0, 2, 1}}));
  EXPECT_EQ (0u, surface.degenerate_faces);
  ASSERT_EQ (1u, surface.components.size ());
  EXPECT_EQ (5u, surface.vertices);
  EXPECT_EQ (6u, surface.inner_edges);
  EXPECT_EQ (6u, surface.edges);
  EXPECT_EQ (2, surface.euler_characteristic);
  EXPECT_TRUE (surface.isOrientable ());
  EXPECT_TRUE (surface.isClosed ());
  // Around 0 the faces are one disc: sides go 1, 2, 3, 4 and back.
  EXPECT_EQ (0u, surface.non_manifold_vertices);
  EXPECT_EQ (0, surface.components[0].genus);
  EXPECT_EQ (1u, surfaceOfRows (rowsOf ({{0, 4, 3, 0, 2, 1}})).non_manifold_vertices);
  EXPECT_EQ (1u, surfaceOfRows (rowsOf ({{0, 4, 3, 0, 2, 1}, {0, 3, 4, 0, 1, 2}})).duplicate_faces);
}

TEST (TopologyReport, EdgesThatAreNoSidesAreCurves)
{
  const pcl::TopologyReport report =
    analyze (rowsOf ({{0, 1, 2, 3}, {3, 2, 5}}), {{1, 0}, {2, 3}, {3, 0}, {0, 2}, {5, 6}, {6, 7}, {6, 5}});
  EXPECT_EQ (7u, report.vertices);
  EXPECT_EQ (4u, report.curve.edges);
  EXPECT_EQ (1u, report.curve.duplicate_edges);
  EXPECT_EQ (2u, report.curve.components.size ());
  EXPECT_EQ (2u, report.surface.faces);
  EXPECT_EQ (1u, report.surface.triangles);
  EXPECT_EQ (0u, report.solid.tetrahedra);
}

TEST (TopologyReport, LargeIndicesNeedNoLargeTables)
{
  SimplicialComplex complex;
  const pcl::index_t top = std::numeric_limits<pcl::index_t>::max ();
  complex.edges = {{0, top}};
  complex.triangles = {{0, top - 1, top}};
  complex.tetrahedra = {{0, top - 2, top - 1, top}};
  const pcl::TopologyReport report = analyze (complex);
  EXPECT_EQ (4u, report.vertices);
  EXPECT_EQ (2u, report.curve.vertices);
  EXPECT_EQ (3u, report.surface.vertices);
  EXPECT_EQ (4u, report.solid.boundary.vertices);
}

TEST (TopologyReport, Curves)
{
  const CurveTopology curve =
    curveOf ({{7, 8}, {0, 1}, {1, 2}, {2, 0}, {10, 11}, {10, 12}, {10, 13}, {13, 14}, {14, 15}, {8, 9}});
  EXPECT_EQ (10u, curve.edges);
  EXPECT_EQ (12u, curve.vertices);
  EXPECT_EQ (5u, curve.end_vertices);
  EXPECT_EQ (1u, curve.branching_vertices);
  ASSERT_EQ (3u, curve.components.size ());
  EXPECT_EQ (5u, curve.components[0].edges); // the branching one
  EXPECT_EQ (6u, curve.components[0].vertices);
  EXPECT_EQ (3u, curve.components[0].end_vertices);
  EXPECT_EQ (1u, curve.components[0].branching_vertices);
  EXPECT_FALSE (curve.components[0].closed);
  EXPECT_EQ (3u, curve.components[1].edges);
  EXPECT_TRUE (curve.components[1].closed);
  EXPECT_EQ (2u, curve.components[2].edges);
  EXPECT_FALSE (curve.components[2].closed);
  EXPECT_EQ (1u, curveOf ({{0, 1}, {1, 2}, {1, 0}}).duplicate_edges);
  // A figure of eight has no end and is not one cycle.
  const CurveTopology eight = curveOf ({{0, 1}, {1, 2}, {2, 0}, {0, 3}, {3, 4}, {4, 0}});
  EXPECT_EQ (0u, eight.end_vertices);
  EXPECT_FALSE (eight.components.at (0).closed);
}

TEST (TopologyReport, Solids)
{
  const SolidTopology one = solidOf ({{0, 1, 2, 3}});
  EXPECT_EQ (4u, one.triangles);
  EXPECT_EQ (4u, one.boundary_triangles);
  expectSurface (one.boundary, 0, 2, true, 0);

  // Two that share a triangle, and one that touches them at an edge.
  const SolidTopology solid = solidOf ({{5, 6, 8, 9}, {0, 1, 2, 3}, {4, 2, 1, 3}, {3, 4, 6, 7}});
  EXPECT_EQ (4u, solid.tetrahedra);
  EXPECT_EQ (10u, solid.vertices);
  EXPECT_EQ (15u, solid.triangles);
  EXPECT_EQ (14u, solid.boundary_triangles);
  EXPECT_EQ (0u, solid.non_manifold_triangles);
  ASSERT_EQ (3u, solid.components.size ());
  EXPECT_EQ (2u, solid.components[0].tetrahedra);
  EXPECT_EQ (5u, solid.components[0].vertices);
  EXPECT_EQ (6u, solid.components[0].boundary_triangles);
  EXPECT_EQ (1u, solid.boundary.non_manifold_edges);

  EXPECT_EQ (1u, solidOf ({{0, 1, 2, 3}, {1, 0, 2, 4}, {0, 1, 2, 5}}).non_manifold_triangles);
}

TEST (TopologyReport, MixedComplex)
{
  SimplicialComplex complex;
  complex.edges = {{0, 1}, {1, 2}};
  complex.triangles = {{2, 3, 4}};
  complex.tetrahedra = {{4, 5, 6, 7}};
  const pcl::TopologyReport report = analyze (complex);
  EXPECT_EQ (8u, report.vertices);
  EXPECT_EQ (1u, report.curve.components.size ());
  EXPECT_EQ (1u, report.surface.components.size ());
  EXPECT_EQ (1u, report.solid.components.size ());
  EXPECT_EQ (0u, report.surface.non_manifold_vertices);
}

} // namespace
