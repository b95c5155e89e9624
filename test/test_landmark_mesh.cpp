// Counts of landmark meshes against known surfaces and the topology report, and triangulations of their
// faces.
#include "oracle_landmark_mesh.h"
#include "oracle_tilings.h"

#include <pcl/manifold/topology_report.h>

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace oracle;
using pcl::manifold::LandmarkComponent;
using pcl::manifold::LandmarkMeshReport;

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

TEST (LandmarkMeshReport, CountsTilings)
{
  for (const Tiling& tiling : tilings ()) {
    const LandmarkMeshReport report =
      analyze (meshOfTiling (tiling), static_cast<std::size_t> (tiling.vertices));
    ASSERT_EQ (report.components.size (), 1u) << tiling.name;
    const LandmarkComponent& total = report.total;
    EXPECT_EQ (total.vertices, static_cast<std::size_t> (tiling.vertices)) << tiling.name;
    EXPECT_EQ (total.triangles, tiling.triangles.size ()) << tiling.name;
    EXPECT_EQ (total.genus (), (2.0 - tiling.euler) / 2.0) << tiling.name;
    EXPECT_EQ (total.boundary_loops, static_cast<std::size_t> (tiling.loops)) << tiling.name;
    EXPECT_EQ (total.orientable, tiling.orientable) << tiling.name;
    EXPECT_EQ (total.edges_in_one_face + total.edges_in_two_faces, total.edges) << tiling.name;
    EXPECT_EQ (total.edges_in_one_face > 0, tiling.loops > 0) << tiling.name;
  }
}

TEST (LandmarkMeshReport, IsOfNothing)
{
  const LandmarkMeshReport nothing = analyze (LandmarkMesh (), 0);
  EXPECT_TRUE (nothing.components.empty ());
  EXPECT_EQ (nothing.total.vertices, 0u);
  EXPECT_TRUE (nothing.total.orientable);
  const LandmarkMeshReport isolated = analyze (LandmarkMesh (), 3);
  EXPECT_EQ (isolated.components.size (), 3u);
  EXPECT_EQ (isolated.total.vertices, 3u);
  EXPECT_EQ (isolated.total.edges, 0u);
}

TEST (LandmarkMeshReport, SortsComponentsBySize)
{
  LandmarkMesh mesh = meshOf ({{1, 2, 3}, {1, 3, 2}, {4, 5, 6, 7}});
  mesh.edges.push_back ({8, 9}); // in no face
  const LandmarkMeshReport report = analyze (mesh, 10);
  ASSERT_EQ (report.components.size (), 4u);
  EXPECT_EQ (report.components[0].vertices, 4u);
  EXPECT_EQ (report.components[0].edges_in_one_face, 4u);
  EXPECT_EQ (report.components[0].boundary_loops, 1u);
  EXPECT_EQ (report.components[1].vertices, 3u);
  EXPECT_EQ (report.components[1].edges_in_two_faces, 3u);
  EXPECT_EQ (report.components[1].genus (), 0.0);
  EXPECT_EQ (report.components[2].edges_in_no_face, 1u);
  EXPECT_EQ (report.components[3].vertices, 1u);
  EXPECT_EQ (report.total.edges_in_no_face, 1u);
  EXPECT_EQ (report.total.triangles, 2u);
}

TEST (LandmarkMeshReport, CountsEdgesOfThreeFaces)
{
  const LandmarkComponent total = analyze (meshOf ({{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}), 5).total;
  EXPECT_EQ (total.edges_in_more_faces, 1u);
  EXPECT_EQ (total.edges_in_one_face, 6u);
}

// Two holes that touch at a landmark are two where the mesh knows them, and one loop where it does not.
TEST (LandmarkMeshReport, TakesTheHolesOfTheMesh)
{
  Tiling disc = gridTiling ("disc", 6, 6, false, false, false);
  // Without the squares (1, 1) and (2, 2), which touch in one corner.
  std::vector<Walk> faces;
  for (std::size_t t = 0; t < disc.triangles.size (); ++t)
    if (t / 2 != 1 * 6 + 1 && t / 2 != 2 * 6 + 2)
      faces.emplace_back (disc.triangles[t].begin (), disc.triangles[t].end ());
  LandmarkMesh mesh = meshOf (faces);
  EXPECT_EQ (analyze (mesh, 49).total.boundary_loops, 2u);
  mesh.holes = {{8, 9, 16, 15}, {16, 17, 24, 23}};
  EXPECT_EQ (analyze (mesh, 49).total.boundary_loops, 3u);
}

// Random parts of tilings: the report of surfaces knows the same loops.
TEST (LandmarkMeshReport, AgreesWithTheReportOfSurfaces)
{
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Random random (seed);
    const std::vector<Tiling> all = tilings ();
    const Tiling& tiling = all[seed % all.size ()];
    std::vector<Walk> faces;
    pcl::manifold::FaceRows rows;
    for (const auto& t : tiling.triangles)
      if (random.index (5) != 0) {
        faces.emplace_back (t.begin (), t.end ());
        rows.vertices.insert (rows.vertices.end (), t.begin (), t.end ());
        rows.starts.push_back (rows.vertices.size ());
      }
    const LandmarkMeshReport report = analyze (meshOf (faces), static_cast<std::size_t> (tiling.vertices));
    const pcl::manifold::SurfaceTopology expected = pcl::manifold::analyzeSurface (rows);
    EXPECT_EQ (report.total.boundary_loops, expected.boundary_loops) << seed;
    EXPECT_EQ (report.total.edges_in_one_face, expected.boundary_edges) << seed;
    EXPECT_EQ (report.total.edges_in_two_faces, expected.inner_edges) << seed;
    EXPECT_EQ (report.total.orientable, std::all_of (expected.components.begin (), expected.components.end (),
                                                     [] (const auto& c) { return c.orientable; }))
      << seed;
  }
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
  EXPECT_EQ (analyze (meshOf (faces), 4).total.edges_in_two_faces, 6u);
}

TEST (TriangulatedFaces, AreNoneOfNothing)
{
  EXPECT_TRUE (triangulateFaces (LandmarkMesh (), Eigen::MatrixXd ()).empty ());
}

} // namespace
