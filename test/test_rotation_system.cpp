// FaceRule::ROTATION_SYSTEM on graphs whose faces are known, and on clouds whose topology is.
#include "oracle_clouds.h"
#include "oracle_graph_kinds.h"
#include "oracle_landmark_mesh.h"
#include "oracle_tilings.h"

#include <gtest/gtest.h>

#include <tbb/global_control.h>

namespace {

using namespace oracle;
using pcl::manifold::AdjacencyRule;
using pcl::manifold::FaceRule;
using pcl::manifold::findFaces;

constexpr int MAXIMUM_LENGTH = 8;

void
expectTopology (const LandmarkMesh& mesh, std::size_t landmarks, int euler, int loops, bool orientable,
                const std::string& name)
{
  const pcl::TopologyReport report = analyze (mesh);
  const pcl::manifold::SurfaceTopology& surface = report.surface;
  EXPECT_EQ (surface.components.size (), 1u) << name;
  EXPECT_EQ (surface.vertices, landmarks) << name;
  EXPECT_EQ (report.curve.edges, 0u) << name;
  EXPECT_EQ (surface.euler_characteristic, euler) << name;
  EXPECT_EQ (surface.boundary_loops, static_cast<std::size_t> (loops)) << name;
  EXPECT_EQ (mesh.holes.size (), static_cast<std::size_t> (loops)) << name;
  EXPECT_EQ (surface.isOrientable (), orientable) << name;
  EXPECT_EQ (surface.non_manifold_edges, 0u) << name;
  EXPECT_EQ (surface.isClosed (), loops == 0) << name;
}

// Every edge passed in both directions.
void
expectOriented (const LandmarkMesh& mesh, const std::string& name)
{
  std::set<std::pair<index_t, index_t>> passed;
  for (const auto* walks : {&mesh.faces, &mesh.holes})
    for (const Walk& walk : *walks)
      for (std::size_t i = 0; i < walk.size (); ++i)
        ASSERT_TRUE (passed.emplace (walk[i], walk[(i + 1) % walk.size ()]).second) << name;
}

TEST (RotationSystemFaces, AreTheTrianglesOfTilings)
{
  for (const Tiling& tiling : tilings ()) {
    const TiledGraph tiled (tiling.vertices, tiling.edges ());
    const LandmarkMesh mesh = tiled.findFaces (FaceRule::ROTATION_SYSTEM, MAXIMUM_LENGTH);
    expectSound (mesh, tiled.contacts, tiled.tiles.size (), MAXIMUM_LENGTH, true, tiling.name);
    std::vector<Walk> expected;
    for (const auto& t : tiling.triangles)
      expected.emplace_back (t.begin (), t.end ());
    EXPECT_EQ (normalizedAll (mesh.faces), normalizedAll (expected)) << tiling.name;
    expectTopology (mesh, tiled.tiles.size (), tiling.euler, tiling.loops, tiling.orientable, tiling.name);
    if (tiling.orientable)
      expectOriented (mesh, tiling.name);
  }
}

TEST (RotationSystemFaces, KeepApartWhatDoesNotTouch)
{
  const Tiling sphere = sphereTiling (5);
  const Tiling torus = gridTiling ("torus", 8, 8, true, true, false);
  EdgeSet edges = sphere.edges ();
  for (const auto& [v, w] : torus.edges ())
    edges.emplace (v + sphere.vertices, w + sphere.vertices);
  const TiledGraph tiled (sphere.vertices + torus.vertices, edges);
  const LandmarkMesh mesh = tiled.findFaces (FaceRule::ROTATION_SYSTEM, MAXIMUM_LENGTH);
  const pcl::manifold::SurfaceTopology surface = analyze (mesh).surface;
  ASSERT_EQ (surface.components.size (), 2u);
  EXPECT_EQ (surface.components[0].vertices, static_cast<std::size_t> (sphere.vertices));
  EXPECT_EQ (surface.components[0].genus, 0);
  EXPECT_EQ (surface.components[1].genus, 1);
  expectOriented (mesh, "sphere and torus");
}

// Extra edges across two triangles of a tiling are crossings: they go, and nothing else does.
TEST (RotationSystemFaces, LeaveOutEdgesThatCrossOthers)
{
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    Random random (seed);
    const Tiling torus = gridTiling ("torus", 11, 12, true, true, false);
    EdgeSet edges = torus.edges ();
    const index_t corner = static_cast<index_t> (random.integer (1, 9) * 11 + random.integer (1, 8));
    edges.emplace (corner + 1, corner + 11); // the other diagonal of a square
    const TiledGraph tiled (torus.vertices, edges);
    const LandmarkMesh mesh = tiled.findFaces (FaceRule::ROTATION_SYSTEM, MAXIMUM_LENGTH);
    EXPECT_EQ (mesh.edges.size (), edges.size () - 1) << seed;
    expectTopology (mesh, tiled.tiles.size (), 0, 0, true, "torus with a crossing");
  }
}

struct Sampled
{
  std::string name;
  std::function<Eigen::Vector3d (Random&)> point;
  int euler;
  int loops;
  bool orientable;
};

Eigen::Vector3d
onMoebiusBand (Random& random)
{
  const double a = random.uniform (0, 2 * M_PI);
  const double t = random.uniform (-0.5, 0.5);
  const double r = 1 + t * std::cos (a / 2);
  return {r * std::cos (a), r * std::sin (a), t * std::sin (a / 2)};
}

struct Found
{
  std::vector<index_t> landmarks;
  std::vector<TileContact> contacts;
  LandmarkMesh mesh;
};

Found
findOn (const NeighborhoodGraph& graph, int hops, std::uint64_t seed, unsigned int threads)
{
  Found found;
  found.landmarks = maximalStableSet (graph, hops, seed, threads);
  const std::vector<index_t> tiles = graphVoronoiDiagram (graph, found.landmarks, threads);
  found.contacts = tileContacts (graph, found.landmarks, tiles, AdjacencyRule::BOUNDARY_POINTS, 7, threads);
  found.mesh = findFaces (graph, tiles, found.landmarks.size (), found.contacts, FaceRule::ROTATION_SYSTEM,
                          MAXIMUM_LENGTH, threads);
  return found;
}

TEST (RotationSystemFaces, HaveTheTopologyOfSampledSurfaces)
{
  const std::vector<Sampled> surfaces{{"sphere", onSphere, 2, 0, true},
                                      {"torus", onTorus, 0, 0, true},
                                      {"sheet", onSheet, 1, 1, true},
                                      {"Moebius band", onMoebiusBand, 0, 1, false}};
  for (const Sampled& surface : surfaces) {
    Random random (5);
    Eigen::MatrixXd points (3, 20000);
    for (Eigen::Index i = 0; i < points.cols (); ++i)
      points.col (i) = surface.point (random);
    NeighborhoodGraph graph;
    ASSERT_EQ (nearestNeighborGraph (points, 15, 0, graph), pcl::manifold::Status::OK);
    for (int hops = 4; hops <= 8; ++hops)
      for (std::uint64_t seed = 0; seed < 4; ++seed) {
        const std::string name =
          surface.name + ", hops " + std::to_string (hops) + ", seed " + std::to_string (seed);
        const Found found = findOn (graph, hops, seed, 0);
        expectSound (found.mesh, found.contacts, found.landmarks.size (), MAXIMUM_LENGTH, true, name);
        expectTopology (found.mesh, found.landmarks.size (), surface.euler, surface.loops, surface.orientable,
                        name);
        if (surface.orientable)
          expectOriented (found.mesh, name);
      }
  }
}

// Where a tube is hardly thicker than its tiles, the other order around some of them would make it one-sided.
TEST (RotationSystemFaces, OfThinTubesAreTwoSided)
{
  constexpr double THICKNESS = 0.2;
  Random random (1);
  Eigen::MatrixXd points (3, 4000);
  for (Eigen::Index i = 0; i < points.cols (); ++i) {
    double around = 0.0, r = 0.0;
    do {
      around = random.uniform (0, 2 * M_PI);
      r = 1 + THICKNESS * std::cos (around);
    } while (random.uniform (0, 1 + THICKNESS) > r);
    const double along = random.uniform (0, 2 * M_PI);
    points.col (i) << r * std::cos (along), r * std::sin (along), THICKNESS * std::sin (around);
  }
  NeighborhoodGraph graph;
  ASSERT_EQ (nearestNeighborGraph (points, 15, 0, graph), pcl::manifold::Status::OK);
  for (int hops = 4; hops <= 5; ++hops)
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      const std::string name = "hops " + std::to_string (hops) + ", seed " + std::to_string (seed);
      const Found found = findOn (graph, hops, seed, 0);
      expectTopology (found.mesh, found.landmarks.size (), 0, 0, true, name);
    }
}

TEST (RotationSystemFaces, AreTheSameOnAnyNumberOfThreads)
{
  const tbb::global_control enough (tbb::global_control::max_allowed_parallelism, 8);
  const NeighborhoodGraph graph = largeGraph ();
  const LandmarkMesh expected = findOn (graph, 4, 1, 1).mesh;
  EXPECT_FALSE (expected.faces.empty ());
  EXPECT_FALSE (expected.holes.empty ());
  for (const unsigned int threads : {2u, 3u, 8u, 0u}) {
    const LandmarkMesh mesh = findOn (graph, 4, 1, threads).mesh;
    EXPECT_EQ (mesh.edges, expected.edges);
    EXPECT_EQ (mesh.faces, expected.faces);
    EXPECT_EQ (mesh.holes, expected.holes);
  }
}

TEST (RotationSystemFaces, AreSoundOnAnyGraph)
{
  forEachGraph (30, 90, [] (const NeighborhoodGraph& graph, const std::string& name) {
    for (const int hops : {1, 2, 3, 5}) {
      const std::vector<index_t> landmarks = maximalStableSet (graph, hops, 3, 1);
      const std::vector<index_t> tiles = graphVoronoiDiagram (graph, landmarks, 1);
      for (const int threshold : {0, 2}) {
        const std::vector<TileContact> contacts =
          tileContacts (graph, landmarks, tiles, AdjacencyRule::BOUNDARY_POINTS, threshold, 1);
        for (const int maximum_length : {-1, 3, 5, 8, 1000}) {
          const LandmarkMesh mesh = findFaces (graph, tiles, landmarks.size (), contacts,
                                               FaceRule::ROTATION_SYSTEM, maximum_length, 1);
          expectSound (mesh, contacts, landmarks.size (), maximum_length, true,
                       name + ", hops " + std::to_string (hops) + ", longest " +
                         std::to_string (maximum_length));
          if (testing::Test::HasFatalFailure ())
            return;
        }
      }
    }
  });
}

// Of tiles that were never reached from a landmark.
TEST (RotationSystemFaces, IgnoreVerticesWithoutTile)
{
  const Tiling torus = gridTiling ("torus", 9, 9, true, true, false);
  TiledGraph tiled (torus.vertices + 3, torus.edges ());
  tiled.tiles.resize (static_cast<std::size_t> (torus.vertices));
  std::vector<index_t> tiles = tiled.tiles;
  tiles.resize (tiles.size () + 3, -1);
  const LandmarkMesh mesh = findFaces (tiled.graph, tiles, tiled.tiles.size (), tiled.contacts,
                                       FaceRule::ROTATION_SYSTEM, MAXIMUM_LENGTH, 1);
  EXPECT_EQ (mesh.faces.size (), torus.triangles.size ());
}

} // namespace
