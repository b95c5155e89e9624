// Surfaces of known topology, and what is no manifold.
#include "test_topology_clouds.h"

#include <algorithm>
#include <random>
#include <vector>

namespace {

using namespace topology;

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

} // namespace
