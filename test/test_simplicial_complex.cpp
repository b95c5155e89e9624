#include <pcl/manifold/simplicial_complex.h>
#include <pcl/manifold/topology_report.h>

#include <pcl/conversions.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

namespace {

using pcl::SimplicialComplex;
using pcl::manifold::boundaryTriangles;
using pcl::manifold::isValid;
using pcl::manifold::Orientation;
using pcl::manifold::orientTriangles;
using pcl::manifold::toPolygonMesh;
using Triangle = SimplicialComplex::Triangle;
using Tetrahedron = SimplicialComplex::Tetrahedron;

double
enclosedVolume (const std::vector<Triangle>& triangles, const Eigen::Matrix3Xd& points)
{
  double sum = 0;
  for (const Triangle& t : triangles) {
    const Eigen::Vector3d a = points.col (t[0]), b = points.col (t[1]), c = points.col (t[2]);
    sum += a.dot (b.cross (c)) / 6;
  }
  return sum;
}

/** \brief How many edges of exactly two triangles are passed by both in the same direction. */
std::size_t
disagreements (const std::vector<Triangle>& triangles)
{
  std::map<std::pair<int, int>, std::pair<int, int>> uses; // edge to uses, forward uses
  for (const Triangle& t : triangles)
    for (int i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax (t[i], t[(i + 1) % 3]);
      ++uses[{low, high}].first;
      uses[{low, high}].second += t[i] == low;
    }
  return static_cast<std::size_t> (std::count_if (uses.begin (), uses.end (), [] (const auto& use) {
    return use.second.first == 2 && use.second.second != 1;
  }));
}

/** \brief n^3 unit cubes of six tetrahedra each, along the cube's diagonal, positively oriented. */
std::vector<Tetrahedron>
cubeOfTetrahedra (int n, Eigen::Matrix3Xd& points)
{
  points.resize (3, (n + 1) * (n + 1) * (n + 1));
  const auto vertex = [n] (const Eigen::Vector3i& p) { return (p[0] * (n + 1) + p[1]) * (n + 1) + p[2]; };
  Eigen::Vector3i p;
  for (p[0] = 0; p[0] <= n; ++p[0])
    for (p[1] = 0; p[1] <= n; ++p[1])
      for (p[2] = 0; p[2] <= n; ++p[2])
        points.col (vertex (p)) = p.cast<double> ();
  std::vector<Tetrahedron> tetrahedra;
  for (p[0] = 0; p[0] < n; ++p[0])
    for (p[1] = 0; p[1] < n; ++p[1])
      for (p[2] = 0; p[2] < n; ++p[2]) {
        std::array<int, 3> axes = {0, 1, 2};
        do {
          const Eigen::Vector3i q = p + Eigen::Vector3i::Unit (axes[0]),
                                r = q + Eigen::Vector3i::Unit (axes[1]);
          Tetrahedron t = {vertex (p), vertex (q), vertex (r), vertex (r + Eigen::Vector3i::Unit (axes[2]))};
          Eigen::Matrix3d m;
          for (int i = 0; i < 3; ++i)
            m.col (i) = points.col (t[static_cast<std::size_t> (i) + 1]) - points.col (t[0]);
          if (m.determinant () < 0)
            std::swap (t[2], t[3]);
          tetrahedra.push_back (t);
        } while (std::next_permutation (axes.begin (), axes.end ()));
      }
  return tetrahedra;
}

TEST (SimplicialComplex, Validity)
{
  SimplicialComplex complex;
  EXPECT_TRUE (isValid (complex, 0));
  complex.edges = {{0, 1}};
  complex.triangles = {{0, 1, 2}};
  complex.tetrahedra = {{0, 1, 2, 3}};
  std::string why;
  EXPECT_TRUE (isValid (complex, 4, &why));
  EXPECT_FALSE (isValid (complex, 3, &why));
  EXPECT_EQ ("tetrahedron 0 has a vertex that the cloud has not: 0, 1, 2, 3", why);
  complex.triangles.push_back ({2, 1, 2});
  EXPECT_FALSE (isValid (complex, 4, &why));
  EXPECT_EQ ("triangle 1 has a vertex twice: 2, 1, 2", why);
  complex.edges.push_back ({-1, 2});
  EXPECT_FALSE (isValid (complex, 4));
}

TEST (SimplicialComplex, BoundaryOfNothing)
{
  EXPECT_TRUE (boundaryTriangles ({}).empty ());
  EXPECT_TRUE (boundaryTriangles ({{0, 0, 1, 2}, {-1, 0, 1, 2}}).empty ());
}

TEST (SimplicialComplex, BoundaryOfOneTetrahedronFacesOutward)
{
  Eigen::Matrix3Xd points (3, 4);
  points << 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1;
  const std::vector<Triangle> boundary = boundaryTriangles ({{0, 1, 2, 3}});
  ASSERT_EQ (4u, boundary.size ());
  EXPECT_EQ (0u, disagreements (boundary));
  EXPECT_DOUBLE_EQ (1.0 / 6, enclosedVolume (boundary, points));
}

TEST (SimplicialComplex, BoundaryOfACube)
{
  Eigen::Matrix3Xd points;
  std::vector<Tetrahedron> tetrahedra = cubeOfTetrahedra (3, points);
  std::mt19937_64 random (3);
  std::shuffle (tetrahedra.begin (), tetrahedra.end (), random);
  const std::vector<Triangle> boundary = boundaryTriangles (tetrahedra);
  EXPECT_EQ (6u * 9 * 2, boundary.size ());
  EXPECT_EQ (0u, disagreements (boundary));
  EXPECT_NEAR (27, enclosedVolume (boundary, points), 1e-9);
  // A side of three tetrahedra is no boundary.
  EXPECT_EQ (9u, boundaryTriangles ({{0, 1, 2, 3}, {0, 1, 2, 4}, {0, 1, 2, 5}}).size ());
}

TEST (SimplicialComplex, OrientNothing)
{
  std::vector<Triangle> triangles;
  EXPECT_EQ (0u, orientTriangles (triangles).patches);
  triangles = {{0, 0, 1}, {2, -1, 3}};
  const std::vector<Triangle> before = triangles;
  EXPECT_EQ (0u, orientTriangles (triangles).patches);
  EXPECT_EQ (before, triangles);
}

TEST (SimplicialComplex, OrientClosedSurfaceOutward)
{
  Eigen::Matrix3Xd points;
  const std::vector<Triangle> good = boundaryTriangles (cubeOfTetrahedra (4, points));
  points.colwise () += Eigen::Vector3d (4e6, -5e6, 100);
  std::mt19937_64 random (5);
  for (int round = 0; round < 20; ++round) {
    std::vector<Triangle> triangles = good;
    for (Triangle& t : triangles)
      if (random () % 2 == 0)
        std::swap (t[0], t[1]);
    std::vector<Triangle> without_points = triangles;
    const Triangle first = triangles[0];
    Orientation result = orientTriangles (without_points);
    EXPECT_EQ (1u, result.patches);
    EXPECT_EQ (0u, result.non_orientable_patches);
    EXPECT_EQ (0u, disagreements (without_points));
    EXPECT_EQ (first, without_points[0]);

    result = orientTriangles (triangles, points);
    EXPECT_EQ (1u, result.patches);
    EXPECT_EQ (0u, disagreements (triangles));
    const Eigen::Matrix3Xd centred = points.colwise () - points.col (0);
    EXPECT_NEAR (64, enclosedVolume (triangles, centred), 1e-9);
  }
}

TEST (SimplicialComplex, OrientPatchesThatAgreeAlready)
{
  // Two cubes, one of them inside out and beside the other, and a third that lost a triangle.
  Eigen::Matrix3Xd cube;
  const std::vector<Triangle> skin = boundaryTriangles (cubeOfTetrahedra (2, cube));
  Eigen::Matrix3Xd points (3, 3 * cube.cols ());
  std::vector<Triangle> triangles;
  for (int copy = 0; copy < 3; ++copy) {
    const auto shift = static_cast<pcl::index_t> (copy * cube.cols ());
    points.middleCols (shift, cube.cols ()) = cube.colwise () + Eigen::Vector3d (5.0 * copy, 0, 0);
    for (Triangle t : skin) {
      if (copy > 0)
        std::swap (t[1], t[2]);
      triangles.push_back ({t[0] + shift, t[1] + shift, t[2] + shift});
    }
  }
  triangles.pop_back ();
  const std::vector<Triangle> before = triangles;
  const Orientation orientation = orientTriangles (triangles, points);
  EXPECT_EQ (orientation.patches, 3u);
  EXPECT_EQ (orientation.non_orientable_patches, 0u);
  EXPECT_EQ (disagreements (triangles), 0u);
  const auto part = [&] (const std::vector<Triangle>& all, std::size_t copy) {
    const auto begin = all.begin () + static_cast<std::ptrdiff_t> (copy * skin.size ());
    return std::vector<Triangle> (begin, copy == 2 ? all.end ()
                                                   : begin + static_cast<std::ptrdiff_t> (skin.size ()));
  };
  EXPECT_EQ (part (triangles, 0), part (before, 0));
  EXPECT_GT (enclosedVolume (part (triangles, 1), points), 0.0);
  // The third one has a boundary, and is bent around its middle all the same.
  std::vector<Triangle> turned = part (before, 2);
  for (Triangle& t : turned)
    std::swap (t[1], t[2]);
  EXPECT_EQ (part (triangles, 2), turned);
}

TEST (SimplicialComplex, OrientOpenAndClosedPatches)
{
  // A tetrahedron facing inward, and two triangles that do not agree and touch it at a vertex.
  std::vector<Triangle> triangles = {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}, {3, 4, 5}, {4, 5, 6}};
  Eigen::Matrix3Xd points (3, 7);
  points << 0, 1, 0, 0, 5, 5, 6, 0, 0, 1, 0, 0, 1, 1, 0, 0, 0, 1, 0, 0, 0;
  const Orientation result = orientTriangles (triangles, points);
  EXPECT_EQ (2u, result.patches);
  EXPECT_EQ (0u, disagreements (triangles));
  EXPECT_GT (enclosedVolume ({triangles.begin (), triangles.begin () + 4}, points), 0);
  EXPECT_EQ ((Triangle{3, 5, 4}), triangles[4]);
  EXPECT_EQ ((Triangle{4, 5, 6}), triangles[5]);
}

TEST (SimplicialComplex, OrientFlatPatchesByTheirFirstTriangles)
{
  Eigen::Matrix3Xd points (3, 4);
  points << 5, 6, 5, 6, 3, 3, 4, 4, 2, 2, 2, 2;
  for (const Triangle& first : {Triangle{0, 1, 2}, Triangle{0, 2, 1}}) {
    std::vector<Triangle> triangles = {first, {1, 3, 2}};
    orientTriangles (triangles, points);
    EXPECT_EQ (first, triangles[0]);
    EXPECT_EQ (0u, disagreements (triangles));
  }
}

TEST (SimplicialComplex, OrientAcrossNonManifoldEdges)
{
  // Two tetrahedra that share the edge 0-1 are two closed patches, each turned outward.
  std::vector<Triangle> triangles = {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3},
                                     {0, 1, 4}, {0, 1, 5}, {0, 4, 5}, {1, 4, 5}};
  Eigen::Matrix3Xd points (3, 6);
  points << 0, 0, 1, 1, -1, -1, 0, 1, 0, 0, 0, 0, 0, 0, 0, 1, 0, 1;
  EXPECT_EQ (2u, orientTriangles (triangles, points).patches);
  EXPECT_GT (enclosedVolume ({triangles.begin (), triangles.begin () + 4}, points), 0);
  EXPECT_GT (enclosedVolume ({triangles.begin () + 4, triangles.end ()}, points), 0);
}

TEST (SimplicialComplex, OrientMoebiusStrip)
{
  std::vector<Triangle> triangles = {{0, 1, 2}, {1, 2, 3}, {2, 3, 4}, {3, 4, 0}, {4, 0, 1}};
  const Orientation result = orientTriangles (triangles);
  EXPECT_EQ (1u, result.patches);
  EXPECT_EQ (1u, result.non_orientable_patches);
  EXPECT_GT (disagreements (triangles), 0u);
}

TEST (SimplicialComplex, OrientLeavesTrianglesWithoutCoordinatesAlone)
{
  std::vector<Triangle> triangles = {{0, 1, 2}, {1, 2, 9}};
  const Eigen::Matrix3Xd points = Eigen::Matrix3Xd::Zero (3, 3);
  EXPECT_EQ (1u, orientTriangles (triangles, points).patches);
  EXPECT_EQ ((Triangle{1, 2, 9}), triangles[1]);
}

TEST (SimplicialComplex, ToPolygonMesh)
{
  pcl::PointCloud<pcl::PointXYZI> cloud (8, 1);
  cloud[7].intensity = 0.25f;
  cloud.header.frame_id = "map";
  pcl::PCLPointCloud2 blob;
  pcl::toPCLPointCloud2 (cloud, blob);
  SimplicialComplex complex;
  pcl::PolygonMesh mesh;
  ASSERT_TRUE (toPolygonMesh (complex, blob, mesh));
  EXPECT_TRUE (mesh.polygons.empty ());
  EXPECT_EQ (blob.data, mesh.cloud.data);

  complex.edges = {{0, 1}};
  complex.triangles = {{1, 2, 3}};
  complex.tetrahedra = {{4, 5, 6, 7}};
  ASSERT_TRUE (toPolygonMesh (complex, blob, mesh));
  ASSERT_EQ (6u, mesh.polygons.size ());
  EXPECT_EQ ((pcl::Indices{0, 1}), mesh.polygons[0].vertices);
  EXPECT_EQ ((pcl::Indices{1, 2, 3}), mesh.polygons[1].vertices);
  EXPECT_EQ (3u, mesh.polygons[5].vertices.size ());
  EXPECT_EQ ("map", mesh.header.frame_id);
  EXPECT_EQ (blob.data, mesh.cloud.data);
  ASSERT_TRUE (toPolygonMesh (complex, mesh.cloud, mesh)); // a mesh's own cloud
  EXPECT_EQ (blob.data, mesh.cloud.data);

  complex.triangles.push_back ({1, 2, 8});
  EXPECT_FALSE (toPolygonMesh (complex, blob, mesh));
  EXPECT_TRUE (mesh.polygons.empty ());
  EXPECT_TRUE (mesh.cloud.data.empty ());
}

} // namespace
