// From the points of a cloud to the vertices of a graph, and from a mesh of landmarks to one that is turned
// outwards.
#include "graph/faces/outward_faces.h"

#include <gtest/gtest.h>
#include <pcl/manifold/cloud_graph.h>
#include <pcl/manifold/reconstruct_graph.h>
#include <pcl/manifold/sample_set.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <random>
#include <set>

namespace {

using namespace pcl::manifold;

constexpr double NOT_A_NUMBER = std::numeric_limits<double>::quiet_NaN ();

Eigen::MatrixXd
randomPoints (Eigen::Index dimension, Eigen::Index n)
{
  std::mt19937_64 engine (3);
  Eigen::MatrixXd points (dimension, n);
  for (Eigen::Index i = 0; i < points.size (); ++i)
    points.data ()[i] = static_cast<float> (engine () >> 40);
  return points;
}

Status
make (const Eigen::MatrixXd& points, int k, CloudGraph& graph, const pcl::Indices& indices = {})
{
  StageLog log;
  return makeCloudGraph (points, indices, FLOAT_RESOLUTION, k, {}, 1, log, graph);
}

/** The edges between the points of the cloud. */
std::set<std::pair<int, int>>
edgesOf (const CloudGraph& cloud, const std::vector<int>& number)
{
  std::set<std::pair<int, int>> edges;
  for (pcl::index_t v = 0; v < cloud.graph.size (); ++v)
    for (const pcl::index_t* w = cloud.graph.begin (v); w != cloud.graph.end (v); ++w)
      edges.emplace (number[static_cast<std::size_t> (cloud.input_index[v])],
                     number[static_cast<std::size_t> (cloud.input_index[*w])]);
  return edges;
}

std::vector<int>
identity (std::size_t n)
{
  std::vector<int> numbers (n);
  std::iota (numbers.begin (), numbers.end (), 0);
  return numbers;
}

TEST (CloudGraph, JoinsEveryPointWithItsNearest)
{
  for (const Eigen::Index dimension : {1, 2, 3, 4, 7}) {
    SCOPED_TRACE (dimension);
    constexpr int N = 300;
    constexpr int K = 5;
    const Eigen::MatrixXd points = randomPoints (dimension, N);
    CloudGraph cloud;
    ASSERT_EQ (make (points, K, cloud), Status::OK);
    ASSERT_TRUE (isProper (cloud.graph));
    std::set<std::pair<int, int>> expected;
    for (int i = 0; i < N; ++i) {
      std::vector<int> order = identity (N);
      std::sort (order.begin (), order.end (), [&] (int a, int b) {
        return (points.col (a) - points.col (i)).squaredNorm () <
               (points.col (b) - points.col (i)).squaredNorm ();
      });
      for (int j = 1; j <= K; ++j) {
        expected.emplace (i, order[static_cast<std::size_t> (j)]);
        expected.emplace (order[static_cast<std::size_t> (j)], i);
      }
    }
    EXPECT_EQ (edgesOf (cloud, identity (N)), expected);
  }
}

TEST (CloudGraph, LeavesOutDuplicatesAndPointsThatAreNotFinite)
{
  for (const Eigen::Index dimension : {2, 3, 5}) {
    SCOPED_TRACE (dimension);
    Eigen::MatrixXd points = randomPoints (dimension, 100);
    points.col (7) = points.col (3);
    points.col (50) = points.col (3);
    points (1, 20) = NOT_A_NUMBER;
    points (0, 21) = std::numeric_limits<double>::infinity ();
    CloudGraph cloud;
    ASSERT_EQ (make (points, 4, cloud), Status::OK);
    EXPECT_EQ (cloud.graph.size (), 96);
    EXPECT_EQ (cloud.points.cols (), 96);
    EXPECT_EQ (cloud.duplicates, 2U);
    EXPECT_EQ (cloud.non_finite, 2U);
    ASSERT_EQ (cloud.vertex_of.size (), 100U);
    EXPECT_EQ (cloud.vertex_of[20], -1);
    EXPECT_EQ (cloud.vertex_of[21], -1);
    EXPECT_EQ (cloud.vertex_of[7], cloud.vertex_of[3]);
    EXPECT_EQ (cloud.vertex_of[50], cloud.vertex_of[3]);
    EXPECT_EQ (cloud.input_index[cloud.vertex_of[3]], 3) << "the first of them";
    for (pcl::index_t v = 0; v < 96; ++v)
      EXPECT_EQ (cloud.vertex_of[static_cast<std::size_t> (cloud.input_index[v])], v);
  }
}

TEST (CloudGraph, NumbersVerticesWhateverTheOrder)
{
  for (const Eigen::Index dimension : {2, 3, 5}) {
    const Eigen::MatrixXd points = randomPoints (dimension, 500);
    Eigen::MatrixXd reversed = points.rowwise ().reverse ();
    CloudGraph one;
    CloudGraph other;
    ASSERT_EQ (make (points, 6, one), Status::OK);
    ASSERT_EQ (make (reversed, 6, other), Status::OK);
    EXPECT_EQ (one.graph.neighbors, other.graph.neighbors);
    EXPECT_EQ (one.graph.offsets, other.graph.offsets);
    EXPECT_EQ (one.points, other.points);
    for (pcl::index_t v = 0; v < 500; ++v)
      EXPECT_EQ (one.input_index[v], 499 - other.input_index[v]);
  }
}

TEST (CloudGraph, SaysWhatItCannotDo)
{
  CloudGraph cloud;
  const Eigen::MatrixXd points = randomPoints (4, 50);
  EXPECT_EQ (make (points, 0, cloud), Status::PARAMETER_OUT_OF_RANGE);
  for (const Eigen::Index dimension : {3, 4}) {
    EXPECT_EQ (make (Eigen::MatrixXd (dimension, 0), 5, cloud), Status::NO_INPUT);
    EXPECT_EQ (make (Eigen::MatrixXd::Constant (dimension, 20, NOT_A_NUMBER), 5, cloud), Status::NO_INPUT);
    EXPECT_EQ (make (Eigen::MatrixXd::Constant (dimension, 20, 1.5), 5, cloud), Status::TOO_FEW_POINTS);
    EXPECT_EQ (cloud.graph.size (), 0);
    EXPECT_TRUE (cloud.vertex_of.empty ());
  }
}

TEST (CloudGraph, CanBeCancelled)
{
  for (int stop = 0; stop < 2; ++stop) {
    int calls = 0;
    StageLog log ([&] (float) { return calls++ < stop; });
    CloudGraph cloud;
    EXPECT_EQ (makeCloudGraph (randomPoints (3, 50), {}, FLOAT_RESOLUTION, 5, {}, 1, log, cloud),
               Status::CANCELLED);
    EXPECT_EQ (calls, stop + 1);
    EXPECT_EQ (cloud.graph.size (), 0);
  }
}

TEST (PolygonsOf, AreOverThePointsOfTheCloud)
{
  GraphMesh mesh;
  mesh.landmarks = {1, 2, 3, 4};
  mesh.mesh.faces = {{0, 1, 2, 3}};
  const pcl::Indices input_index = {10, 20, 30, 40, 50};
  std::vector<pcl::Vertices> polygons = polygonsOf (mesh, input_index);
  ASSERT_EQ (polygons.size (), 1U);
  EXPECT_EQ (polygons[0].vertices, (pcl::Indices{20, 30, 40, 50}));
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  polygons = polygonsOf (mesh, input_index);
  ASSERT_EQ (polygons.size (), 2U);
  EXPECT_EQ (polygons[1].vertices, (pcl::Indices{20, 40, 50}));
}

/** A cube's faces seen from outside, one of them missing. */
LandmarkMesh
openCube ()
{
  LandmarkMesh mesh;
  mesh.faces = {{0, 2, 3, 1}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  mesh.holes = {{4, 5, 7, 6}};
  return mesh;
}

Eigen::Matrix3Xd
cubePoints ()
{
  Eigen::Matrix3Xd points (3, 8);
  for (int i = 0; i < 8; ++i)
    points.col (i) = Eigen::Vector3d (i & 1, i >> 1 & 1, i >> 2);
  return points;
}

void
reverseAll (std::vector<std::vector<pcl::index_t>>& walks)
{
  for (auto& walk : walks)
    std::reverse (walk.begin () + 1, walk.end ());
}

TEST (OutwardFaces, StayAsTheyAreOrAreTurnedTogether)
{
  // Far from the origin too.
  const Eigen::Matrix3Xd points = cubePoints ().colwise () + Eigen::Vector3d (100.0, -200.0, 50.0);
  LandmarkMesh mesh = openCube ();
  turnOutward (mesh, points);
  EXPECT_EQ (mesh.faces, openCube ().faces);
  EXPECT_EQ (mesh.holes, openCube ().holes);
  reverseAll (mesh.faces);
  reverseAll (mesh.holes);
  turnOutward (mesh, points);
  EXPECT_EQ (mesh.faces, openCube ().faces);
  EXPECT_EQ (mesh.holes, openCube ().holes);
}

TEST (OutwardFaces, AreTurnedPartByPart)
{
  Eigen::Matrix3Xd points (3, 16);
  points << cubePoints (), cubePoints ().colwise () + Eigen::Vector3d (5.0, 0.0, 0.0);
  LandmarkMesh expected = openCube ();
  LandmarkMesh second = openCube ();
  for (auto* walks : {&second.faces, &second.holes})
    for (auto& walk : *walks)
      for (pcl::index_t& v : walk)
        v += 8;
  LandmarkMesh mesh = expected;
  expected.faces.insert (expected.faces.end (), second.faces.begin (), second.faces.end ());
  expected.holes.insert (expected.holes.end (), second.holes.begin (), second.holes.end ());
  reverseAll (second.faces);
  reverseAll (second.holes);
  mesh.faces.insert (mesh.faces.end (), second.faces.begin (), second.faces.end ());
  mesh.holes.insert (mesh.holes.end (), second.holes.begin (), second.holes.end ());
  turnOutward (mesh, points);
  EXPECT_EQ (mesh.faces, expected.faces);
  EXPECT_EQ (mesh.holes, expected.holes);
}

TEST (OutwardFaces, MayBeNone)
{
  LandmarkMesh mesh;
  turnOutward (mesh, Eigen::Matrix3Xd (3, 0));
  EXPECT_TRUE (mesh.faces.empty ());
}

} // namespace
