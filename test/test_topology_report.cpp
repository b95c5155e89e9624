#include "oracle_topology.h"

#include <pcl/manifold/topology_report.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <set>

namespace {

using pcl::SimplicialComplex;
using pcl::manifold::analyze;
using pcl::manifold::CurveTopology;
using pcl::manifold::FaceRows;
using pcl::manifold::SolidTopology;
using pcl::manifold::SurfaceComponent;
using pcl::manifold::SurfaceTopology;
using Edge = SimplicialComplex::Edge;
using Triangle = SimplicialComplex::Triangle;
using Tetrahedron = SimplicialComplex::Tetrahedron;

SurfaceTopology
surfaceOf (const std::vector<Triangle>& triangles)
{
  SimplicialComplex complex;
  complex.triangles = triangles;
  return analyze (complex).surface;
}

SurfaceTopology
surfaceOfRows (const FaceRows& faces)
{
  return analyze (faces).surface;
}

CurveTopology
curveOf (const std::vector<Edge>& edges)
{
  SimplicialComplex complex;
  complex.edges = edges;
  return analyze (complex).curve;
}

SolidTopology
solidOf (const std::vector<Tetrahedron>& tetrahedra)
{
  SimplicialComplex complex;
  complex.tetrahedra = tetrahedra;
  return analyze (complex).solid;
}

std::vector<Triangle>
tetrahedronBoundary (int base = 0)
{
  return {{base, base + 2, base + 1},
          {base, base + 1, base + 3},
          {base, base + 3, base + 2},
          {base + 1, base + 2, base + 3}};
}

/** \brief n x m squares of two triangles; the last column of vertices is the first one where \a around, or
 * the first one upside down where \a twisted; the last row likewise is the first where \a closed. */
std::vector<Triangle>
grid (int n, int m, bool around = false, bool twisted = false, bool closed = false)
{
  const int rows = closed ? m : m + 1;
  const auto vertex = [&] (int i, int j) {
    j = closed ? j % m : j;
    if (i == n && twisted)
      return (closed ? (m - j) % m : m - j);
    return (i == n && around ? 0 : i) * rows + j;
  };
  std::vector<Triangle> triangles;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j) {
      triangles.push_back ({vertex (i, j), vertex (i + 1, j), vertex (i + 1, j + 1)});
      triangles.push_back ({vertex (i, j), vertex (i + 1, j + 1), vertex (i, j + 1)});
    }
  return triangles;
}

void
expectSurface (const SurfaceTopology& surface, std::size_t loops, int euler, bool orientable, int genus)
{
  EXPECT_TRUE (surface.isManifold ());
  ASSERT_EQ (1u, surface.components.size ());
  const SurfaceComponent& component = surface.components.front ();
  EXPECT_EQ (loops, component.boundary_loops);
  EXPECT_EQ (loops, surface.boundary_loops);
  EXPECT_EQ (loops == 0, component.closed);
  EXPECT_EQ (loops == 0, surface.isClosed ());
  EXPECT_EQ (euler, component.euler_characteristic);
  EXPECT_EQ (euler, surface.euler_characteristic);
  EXPECT_EQ (orientable, component.orientable);
  EXPECT_EQ (genus, component.genus);
  EXPECT_EQ (surface.faces, component.faces);
  EXPECT_EQ (surface.vertices, component.vertices);
  EXPECT_EQ (surface.edges, component.edges);
  EXPECT_EQ (component.edges, component.boundary_edges + component.inner_edges);
}

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

TEST (TopologyReport, KnownSurfaces)
{
  expectSurface (surfaceOf ({{0, 1, 2}}), 1, 1, true, 0);
  expectSurface (surfaceOf (tetrahedronBoundary ()), 0, 2, true, 0);
  expectSurface (
    surfaceOf ({{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}, {5, 2, 1}, {5, 3, 2}, {5, 4, 3}, {5, 1, 4}}), 0,
    2, true, 0); // octahedron
  expectSurface (surfaceOf (grid (4, 3)), 1, 1, true, 0);
  expectSurface (surfaceOf (grid (5, 2, true)), 2, 0, true, 0);              // annulus
  expectSurface (surfaceOf (grid (5, 2, true, true)), 1, 0, false, 1);       // Moebius strip
  expectSurface (surfaceOf (grid (7, 5, true, false, true)), 0, 0, true, 1); // torus
  expectSurface (surfaceOf (grid (7, 5, true, true, true)), 0, 0, false, 2); // Klein bottle
  expectSurface (surfaceOf ({{0, 1, 2},
                             {0, 2, 3},
                             {0, 3, 4},
                             {0, 4, 5},
                             {0, 5, 1},
                             {1, 2, 4},
                             {2, 3, 5},
                             {3, 4, 1},
                             {4, 5, 2},
                             {5, 1, 3}}),
                 0, 1, false, 1); // projective plane of six vertices
}

TEST (TopologyReport, TorusWithHoles)
{
  std::vector<Triangle> triangles = grid (9, 8, true, false, true);
  triangles.erase (triangles.begin () + 60);
  triangles.erase (triangles.begin () + 10);
  expectSurface (surfaceOf (triangles), 2, -2, true, 1);
}

TEST (TopologyReport, DirectionOfFacesDoesNotMatter)
{
  std::vector<Triangle> torus = grid (7, 5, true, false, true);
  std::mt19937_64 random (1);
  for (Triangle& t : torus)
    if (random () % 2 == 0)
      std::swap (t[0], t[1]);
  std::shuffle (torus.begin (), torus.end (), random);
  expectSurface (surfaceOf (torus), 0, 0, true, 1);
}

TEST (TopologyReport, TwoTrianglesAtAVertex)
{
  const SurfaceTopology surface = surfaceOf ({{0, 1, 2}, {2, 3, 4}});
  EXPECT_EQ (2u, surface.components.size ());
  EXPECT_EQ (2u, surface.boundary_loops);
  EXPECT_EQ (0u, surface.non_manifold_edges);
  EXPECT_EQ (1u, surface.non_manifold_vertices);
  EXPECT_EQ (5u, surface.vertices);
  EXPECT_EQ (1, surface.euler_characteristic);
  for (const SurfaceComponent& component : surface.components) {
    EXPECT_EQ (3u, component.vertices);
    EXPECT_EQ (1u, component.non_manifold_vertices);
    EXPECT_EQ (1, component.euler_characteristic);
    EXPECT_EQ (0, component.genus);
  }
}

TEST (TopologyReport, ThreeTrianglesAtAnEdge)
{
  const SurfaceTopology surface = surfaceOf ({{0, 1, 2}, {0, 1, 3}, {0, 1, 4}});
  ASSERT_EQ (1u, surface.components.size ());
  EXPECT_EQ (1u, surface.non_manifold_edges);
  EXPECT_EQ (2u, surface.non_manifold_vertices);
  EXPECT_EQ (6u, surface.boundary_edges);
  EXPECT_EQ (0u, surface.inner_edges);
  EXPECT_EQ (1u, surface.boundary_loops);
  EXPECT_EQ (-1, surface.components[0].genus);
  EXPECT_TRUE (surface.components[0].orientable);
  EXPECT_FALSE (surface.isManifold ());
}

TEST (TopologyReport, ClosedSurfacesSharingAnEdge)
{
  std::vector<Triangle> triangles = tetrahedronBoundary ();
  for (Triangle t : tetrahedronBoundary ()) { // a second one over the vertices 0, 1, 4, 5
    for (pcl::index_t& v : t)
      v = v < 2 ? v : v + 2;
    triangles.push_back (t);
  }
  const SurfaceTopology surface = surfaceOf (triangles);
  ASSERT_EQ (1u, surface.components.size ());
  EXPECT_TRUE (surface.isClosed ());
  EXPECT_EQ (1u, surface.non_manifold_edges);
  EXPECT_EQ (2u, surface.non_manifold_vertices);
  EXPECT_EQ (0u, surface.boundary_loops);
}

TEST (TopologyReport, TwoUmbrellasAtAVertex)
{
  std::vector<Triangle> triangles = tetrahedronBoundary ();
  for (const Triangle& t : tetrahedronBoundary (3))
    triangles.push_back (t);
  const SurfaceTopology surface = surfaceOf (triangles);
  ASSERT_EQ (2u, surface.components.size ());
  EXPECT_EQ (1u, surface.non_manifold_vertices);
  EXPECT_TRUE (surface.isClosed ());
  EXPECT_EQ (3, surface.euler_characteristic);
  for (const SurfaceComponent& component : surface.components) {
    EXPECT_EQ (2, component.euler_characteristic);
    EXPECT_EQ (0, component.genus);
  }
}

TEST (TopologyReport, HolesThatTouch)
{
  // In a disc, two holes that touch at an inner vertex: cut there, one hole is left.
  std::vector<Triangle> triangles = grid (4, 4);
  const auto square = [&] (int i, int j) { return triangles.begin () + 2 * (4 * i + j); };
  triangles.erase (square (2, 2), square (2, 3));
  triangles.erase (square (1, 1), square (1, 2));
  const SurfaceTopology surface = surfaceOf (triangles);
  ASSERT_EQ (1u, surface.components.size ());
  EXPECT_EQ (1u, surface.non_manifold_vertices);
  EXPECT_EQ (0u, surface.non_manifold_edges);
  EXPECT_EQ (2u, surface.boundary_loops);
  EXPECT_EQ (-1, surface.euler_characteristic);
  EXPECT_EQ (0, surface.components[0].genus);
}

TEST (TopologyReport, PinchedTorus)
{
  // A tube over the vertices 0 to 14 whose two ends are closed over one and the same vertex.
  std::vector<Triangle> triangles = grid (5, 2, true);
  for (int i = 0; i < 5; ++i) {
    triangles.push_back ({99, 3 * i, 3 * ((i + 1) % 5)});
    triangles.push_back ({99, 3 * i + 2, 3 * ((i + 1) % 5) + 2});
  }
  const SurfaceTopology surface = surfaceOf (triangles);
  ASSERT_EQ (1u, surface.components.size ());
  EXPECT_EQ (1u, surface.non_manifold_vertices);
  EXPECT_TRUE (surface.isClosed ());
  EXPECT_EQ (1, surface.euler_characteristic);
  EXPECT_EQ (0, surface.components[0].genus); // a sphere once its vertex is split
}

TEST (TopologyReport, DuplicateFaces)
{
  const SurfaceTopology pillow = surfaceOf ({{0, 1, 2}, {2, 1, 0}});
  EXPECT_EQ (1u, pillow.duplicate_faces);
  EXPECT_TRUE (pillow.isClosed ());
  EXPECT_FALSE (pillow.isManifold ());
  EXPECT_EQ (2u, surfaceOf ({{0, 1, 2}, {2, 1, 0}, {1, 2, 0}, {0, 1, 3}}).duplicate_faces);
  EXPECT_EQ (0u, surfaceOf ({{0, 1, 2}, {0, 1, 3}, {0, 1, 4}, {0, 1, 5}}).duplicate_faces);
}

TEST (TopologyReport, Polygons)
{
  FaceRows cube;
  cube.vertices = {0, 1, 2, 3, 4, 5, 6, 7, 0, 1, 5, 4, 1, 2, 6, 5, 2, 3, 7, 6, 3, 0, 4, 7};
  cube.starts = {0, 4, 8, 12, 16, 20, 24};
  expectSurface (surfaceOfRows (cube), 0, 2, true, 0);

  FaceRows prism; // over a pentagon, without its lid
  prism.vertices = {0, 1, 2, 3, 4};
  prism.starts = {0, 5};
  for (int i = 0; i < 5; ++i) {
    const int j = (i + 1) % 5;
    prism.vertices.insert (prism.vertices.end (), {i, j, j + 5, i + 5});
    prism.starts.push_back (prism.vertices.size ());
  }
  const SurfaceTopology surface = surfaceOfRows (prism);
  expectSurface (surface, 1, 1, true, 0);
  EXPECT_EQ (5u, surface.boundary_edges);

  FaceRows quads; // the same four vertices in the same and in another order
  quads.vertices = {0, 1, 2, 3, 2, 1, 0, 3, 0, 2, 1, 3};
  quads.starts = {0, 4, 8, 12};
  EXPECT_EQ (1u, surfaceOfRows (quads).duplicate_faces);
}

TEST (TopologyReport, ComponentsAreSortedBySize)
{
  std::vector<Triangle> triangles = {{100, 101, 102}};
  for (const Triangle& t : tetrahedronBoundary (50))
    triangles.push_back (t);
  for (const Triangle& t : grid (5, 2, true))
    triangles.push_back (t);
  triangles.push_back ({200, 201, 202});
  const SurfaceTopology surface = surfaceOf (triangles);
  ASSERT_EQ (4u, surface.components.size ());
  EXPECT_EQ (20u, surface.components[0].faces);
  EXPECT_EQ (4u, surface.components[1].faces);
  EXPECT_EQ (1u, surface.components[2].faces);
  EXPECT_TRUE (surface.components[1].closed);
  EXPECT_FALSE (surface.isClosed ());
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

TEST (TopologyReport, RandomSoupsAgreeWithPlainCounting)
{
  std::mt19937_64 random (20240607);
  for (int round = 0; round < 1500; ++round) {
    const int vertices = 4 + static_cast<int> (random () % 7);
    std::set<Triangle> sorted;
    std::vector<Triangle> triangles;
    for (int i = 0, n = 1 + static_cast<int> (random () % 9); i < n; ++i) {
      Triangle t;
      for (pcl::index_t& v : t)
        v = static_cast<int> (random () % static_cast<unsigned> (vertices));
      Triangle s = t;
      std::sort (s.begin (), s.end ());
      if (s[0] != s[1] && s[1] != s[2] && sorted.insert (s).second)
        triangles.push_back (t);
    }
    if (triangles.empty ())
      continue;
    const oracle::Surface expected_surface (triangles);
    const SurfaceTopology surface = surfaceOf (triangles);
    const std::vector<SurfaceComponent> expected = expected_surface.components ();
    ASSERT_EQ (expected.size (), surface.components.size ()) << "round " << round;
    std::set<int> used;
    std::size_t non_manifold = 0;
    for (const Triangle& t : triangles)
      for (const int v : t)
        if (used.insert (v).second)
          non_manifold += !expected_surface.isManifold (v);
    EXPECT_EQ (used.size (), surface.vertices);
    EXPECT_EQ (non_manifold, surface.non_manifold_vertices) << "round " << round;
    EXPECT_EQ (0u, surface.duplicate_faces) << "round " << round;
    for (std::size_t i = 0; i < expected.size (); ++i) {
      const SurfaceComponent &e = expected[i], &c = surface.components[i];
      EXPECT_EQ (e.faces, c.faces) << "round " << round;
      EXPECT_EQ (e.vertices, c.vertices) << "round " << round;
      EXPECT_EQ (e.edges, c.edges) << "round " << round;
      EXPECT_EQ (e.boundary_edges, c.boundary_edges) << "round " << round;
      EXPECT_EQ (e.inner_edges, c.inner_edges) << "round " << round;
      EXPECT_EQ (e.non_manifold_edges, c.non_manifold_edges) << "round " << round;
      EXPECT_EQ (e.non_manifold_vertices, c.non_manifold_vertices) << "round " << round;
      EXPECT_EQ (e.boundary_loops, c.boundary_loops) << "round " << round;
      EXPECT_EQ (e.euler_characteristic, c.euler_characteristic) << "round " << round;
      EXPECT_EQ (e.orientable, c.orientable) << "round " << round;
      EXPECT_EQ (e.closed, c.closed) << "round " << round;
      if (c.non_manifold_edges > 0)
        EXPECT_EQ (-1, c.genus);
      else
        EXPECT_LE (0, c.genus) << "round " << round;
    }
  }
}

} // namespace
