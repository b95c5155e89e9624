// Random sets of triangles against plain counting.
#include "oracle_topology.h"
#include "test_topology_clouds.h"

#include <algorithm>
#include <random>
#include <set>
#include <vector>

namespace {

using namespace topology;

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
