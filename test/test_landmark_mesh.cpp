// The topology of landmark meshes against known surfaces, and triangulations of their faces.
#include "oracle_landmark_mesh.h"
#include "oracle_tilings.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace oracle;
using pcl::manifold::SurfaceTopology;

LandmarkMesh
meshOf (std::vector<Walk> faces)
{
  LandmarkMesh mesh;
  mesh.faces = std::move (faces);
  for (const auto& [edge, count] : countSides (mesh.faces))
    mesh.edges.push_back (edge);
  return mesh;
}

LandmarkMesh
meshOfTiling (const Tiling& tiling)
{
  std::vector<Walk> faces;
  for (const auto& t : tiling.triangles)
    faces.emplace_back (t.begin (), t.end ());
  return meshOf (faces);
}

TEST (LandmarkMeshTopology, IsThatOfTheTiling)
{
  for (const Tiling& tiling : tilings ()) {
    const pcl::TopologyReport report = analyze (meshOfTiling (tiling));
    const SurfaceTopology& surface = report.surface;
    ASSERT_EQ (surface.components.size (), 1u) << tiling.name;
    EXPECT_EQ (report.vertices, static_cast<std::size_t> (tiling.vertices)) << tiling.name;
    EXPECT_EQ (surface.triangles, tiling.triangles.size ()) << tiling.name;
    EXPECT_EQ (surface.euler_characteristic, tiling.euler) << tiling.name;
    EXPECT_EQ (surface.boundary_loops, static_cast<std::size_t> (tiling.loops)) << tiling.name;
    EXPECT_EQ (surface.isOrientable (), tiling.orientable) << tiling.name;
    EXPECT_EQ (report.curve.edges, 0u) << tiling.name;
  }
}

TEST (LandmarkMeshTopology, IsOfNothing)
{
  const pcl::TopologyReport nothing = analyze (LandmarkMesh ());
  EXPECT_EQ (nothing.vertices, 0u);
  EXPECT_TRUE (nothing.surface.components.empty ());
  EXPECT_TRUE (nothing.curve.components.empty ());
}

TEST (LandmarkMeshTopology, TakesEdgesInNoFaceForCurves)
{
  LandmarkMesh mesh = meshOf ({{1, 2, 3}, {1, 3, 2}, {4, 5, 6, 7}});
  mesh.edges.push_back ({3, 4}); // a wire between the two surfaces, and one beside them
  mesh.edges.push_back ({8, 9});
  const pcl::TopologyReport report = analyze (mesh);
  EXPECT_EQ (report.vertices, 9u);
  EXPECT_EQ (report.curve.edges, 2u);
  EXPECT_EQ (report.curve.components.size (), 2u);
  ASSERT_EQ (report.surface.components.size (), 2u);
  EXPECT_EQ (report.surface.faces, 3u);
  EXPECT_EQ (report.surface.triangles, 2u);
  EXPECT_TRUE (report.surface.components[0].closed);
  EXPECT_EQ (report.surface.components[0].genus, 0);
  EXPECT_EQ (report.surface.components[1].boundary_edges, 4u);
}

Eigen::MatrixXd
regularPolygon (int n)
{
  Eigen::MatrixXd points (2, n);
  for (int i = 0; i < n; ++i)
    points.col (i) << std::cos (2 * M_PI * i / n), std::sin (2 * M_PI * i / n);
  return points;
}

Walk
numbersUpTo (int n)
{
  Walk walk;
  for (index_t i = 0; i < n; ++i)
    walk.push_back (i);
  return walk;
}

// The triangles as a surface whose boundary is the face, passed in the face's direction.
void
expectFills (const std::vector<std::array<index_t, 3>>& triangles, const Walk& face, const std::string& name)
{
  ASSERT_EQ (triangles.size (), face.size () - 2) << name;
  std::set<std::pair<index_t, index_t>> sides;
  for (const auto& t : triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::pair<index_t, index_t> side{t[i], t[(i + 1) % 3]};
      ASSERT_TRUE (sides.insert (side).second) << name;
    }
  for (std::size_t i = 0; i < face.size (); ++i)
    ASSERT_EQ (sides.erase ({face[i], face[(i + 1) % face.size ()]}), 1u) << name;
  for (const auto& [a, b] : sides)
    ASSERT_EQ (sides.count ({b, a}), 1u) << name;
}

TEST (TriangulatedFaces, FillFacesInTheirDirection)
{
  for (const int n : {3, 4, 5, 6, 8, 23, 24, 25, 26, 100, 1000}) {
    const LandmarkMesh mesh = meshOf (std::vector<Walk>{numbersUpTo (n)});
    expectFills (triangulateFaces (mesh, regularPolygon (n)), mesh.faces[0], "polygon " + std::to_string (n));
    expectFills (triangulateFaces (mesh, Eigen::MatrixXd ()), mesh.faces[0], "graph " + std::to_string (n));
  }
}

double
lengthOfDiagonals (const std::vector<std::array<index_t, 3>>& triangles, const Eigen::MatrixXd& points)
{
  double length = 0.0;
  for (const auto& t : triangles)
    for (std::size_t i = 0; i < 3; ++i)
      length += (points.col (t[i]) - points.col (t[(i + 1) % 3])).norm ();
  return length;
}

// The shortest of all triangulations of part [i, j] of a polygon, each edge of a triangle counted there.
double
shortest (const Eigen::MatrixXd& points, Eigen::Index i, Eigen::Index j)
{
  double best = j < i + 2 ? 0.0 : std::numeric_limits<double>::infinity ();
  for (Eigen::Index k = i + 1; k < j; ++k)
    best = std::min (
      best, shortest (points, i, k) + shortest (points, k, j) + (points.col (i) - points.col (k)).norm () +
              (points.col (k) - points.col (j)).norm () + (points.col (i) - points.col (j)).norm ());
  return best;
}

TEST (TriangulatedFaces, HaveTheShortestDiagonals)
{
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    Random random (seed);
    const int n = random.integer (4, 9);
    Eigen::MatrixXd points (3, n);
    for (Eigen::Index i = 0; i < n; ++i)
      points.col (i) << random.uniform (), random.uniform (), random.uniform ();
    const auto triangles = triangulateFaces (meshOf (std::vector<Walk>{numbersUpTo (n)}), points);
    EXPECT_NEAR (lengthOfDiagonals (triangles, points), shortest (points, 0, n - 1), 1e-9) << seed;
  }
}

TEST (TriangulatedFaces, UseNoEdgeThatIsThere)
{
  // The shorter diagonal of the square is an edge of the mesh already.
  LandmarkMesh mesh = meshOf ({{0, 1, 2, 3}});
  mesh.edges.push_back ({0, 2});
  Eigen::MatrixXd points (2, 4);
  points << 0, 4, 0.5, -4, /**/ 0, 0, 0.5, 0;
  for (const Eigen::MatrixXd& coordinates : {points, Eigen::MatrixXd ()}) {
    const auto triangles = triangulateFaces (mesh, coordinates);
    ASSERT_EQ (triangles.size (), 2u);
    for (const auto& t : triangles)
      EXPECT_FALSE (std::count (t.begin (), t.end (), 0) == 1 && std::count (t.begin (), t.end (), 2) == 1);
  }
  // Both sides of a square: the second one takes the other diagonal.
  const auto sides = triangulateFaces (meshOf ({{0, 1, 2, 3}, {0, 3, 2, 1}}), regularPolygon (4));
  std::vector<Walk> faces;
  for (const auto& t : sides)
    faces.emplace_back (t.begin (), t.end ());
  EXPECT_EQ (analyze (meshOf (faces)).surface.inner_edges, 6u);
}

TEST (TriangulatedFaces, AreNoneOfNothing)
{
  EXPECT_TRUE (triangulateFaces (LandmarkMesh (), Eigen::MatrixXd ()).empty ());
}

} // namespace
