#pragma once

#include <pcl/manifold/topology_report.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

/** What the tests of the topology report share: small complexes, and what is expected of a surface. */
namespace topology {

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

inline SurfaceTopology
surfaceOf (const std::vector<Triangle>& triangles)
{
  SimplicialComplex complex;
  complex.triangles = triangles;
  return analyze (complex).surface;
}

inline SurfaceTopology
surfaceOfRows (const FaceRows& faces)
{
  return analyze (faces).surface;
}

inline CurveTopology
curveOf (const std::vector<Edge>& edges)
{
  SimplicialComplex complex;
  complex.edges = edges;
  return analyze (complex).curve;
}

inline SolidTopology
solidOf (const std::vector<Tetrahedron>& tetrahedra)
{
  SimplicialComplex complex;
  complex.tetrahedra = tetrahedra;
  return analyze (complex).solid;
}

inline std::vector<Triangle>
tetrahedronBoundary (int base = 0)
{
  return {{base, base + 2, base + 1},
          {base, base + 1, base + 3},
          {base, base + 3, base + 2},
          {base + 1, base + 2, base + 3}};
}

/** \brief n x m squares of two triangles; the last column of vertices is the first one where \a around, or
 * the first one upside down where \a twisted; the last row likewise is the first where \a closed. */
inline std::vector<Triangle>
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

inline void
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

} // namespace topology
