// Whatever the cloud, open or watertight: what the manifold extraction of COCONESHAPE promises.
#include "oracle_clouds.h"

#include "common/parallel.h"
#include "extraction/extract_shape.h"
#include "voronoi/dimension.h"

#include <pcl/manifold/reconstruct_shape.h>
#include <pcl/manifold/topology_report.h>

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace {

using namespace oracle;
using pcl::SimplicialComplex;
using pcl::manifold::analyze;
using pcl::manifold::DelaunayComplex;
using pcl::manifold::SampleDimensions;
using pcl::manifold::SampleSet;
using pcl::manifold::ShapeParameters;
using pcl::manifold::StageLog;
using pcl::manifold::Status;
using Simplex = std::set<pcl::index_t>;

// Adds the sides of a simplex that have so many vertices.
template <typename Cell>
void
addSides (const Cell& cell, std::size_t vertices, std::set<Simplex>& sides)
{
  for (unsigned int chosen = 0; chosen < 1u << cell.size (); ++chosen) {
    Simplex side;
    for (std::size_t k = 0; k < cell.size (); ++k)
      if ((chosen >> k & 1) != 0)
        side.insert (cell[k]);
    if (side.size () == vertices)
      sides.insert (side);
  }
}

// The first promise that a shape breaks; empty if it keeps them all.
std::string
brokenPromise (const SimplicialComplex& shape, const SampleSet& samples, bool watertight)
{
  std::string why;
  if (!pcl::manifold::isValid (shape, static_cast<std::size_t> (samples.size ()), &why))
    return why;
  const pcl::TopologyReport report = analyze (shape);
  if (report.curve.branching_vertices > 0 || report.curve.duplicate_edges > 0)
    return "a curve branches";
  if (report.surface.non_manifold_edges > 0)
    return "the surface is not edge-manifold";
  if (report.surface.non_manifold_vertices > 0)
    return "the surface is not vertex-manifold";
  if (report.surface.duplicate_faces > 0)
    return "a triangle twice";
  if (watertight && !report.surface.isClosed ())
    return "the surface is not closed";
  if (report.solid.non_manifold_triangles > 0)
    return "a triangle of three tetrahedra";
  if (!report.solid.boundary.isManifold () || !report.solid.boundary.isClosed ())
    return "the boundary of the solids is no manifold";

  if (watertight && !report.surface.isOrientable ())
    return "a closed surface with one side";

  std::set<Simplex> edges;
  std::set<Simplex> triangles;
  for (const auto& triangle : shape.triangles)
    addSides (triangle, 2, edges);
  for (const auto& tetrahedron : shape.tetrahedra) {
    addSides (tetrahedron, 2, edges);
    addSides (tetrahedron, 3, triangles);
    Eigen::Matrix3d sides;
    for (int k = 0; k < 3; ++k)
      sides.col (k) = samples.points.col (tetrahedron[static_cast<std::size_t> (k) + 1]) -
                      samples.points.col (tetrahedron[0]);
    if (sides.determinant () < -1e-12)
      return "a tetrahedron turned over";
  }
  for (const auto& edge : shape.edges)
    if (edges.count (Simplex (edge.begin (), edge.end ())) != 0)
      return "an edge that is a side";
  for (const auto& triangle : shape.triangles)
    if (triangles.count (Simplex (triangle.begin (), triangle.end ())) != 0)
      return "a triangle that is a side";
  return "";
}

// Triangles of a surface that is edge-manifold, part by part of those that hang together through edges.
std::vector<SimplicialComplex>
partsOf (const SimplicialComplex& shape)
{
  std::map<Simplex, std::vector<std::size_t>> at_edge;
  for (std::size_t i = 0; i < shape.triangles.size (); ++i)
    for (std::size_t k = 0; k < 3; ++k)
      at_edge[{shape.triangles[i][k], shape.triangles[i][(k + 1) % 3]}].push_back (i);
  std::vector<SimplicialComplex> parts;
  std::vector<std::uint8_t> taken (shape.triangles.size (), 0);
  for (std::size_t seed = 0; seed < taken.size (); ++seed) {
    if (taken[seed] != 0)
      continue;
    parts.emplace_back ();
    taken[seed] = 1;
    for (std::vector<std::size_t> front{seed}; !front.empty ();) {
      const SimplicialComplex::Triangle& triangle = shape.triangles[front.back ()];
      front.pop_back ();
      parts.back ().triangles.push_back (triangle);
      for (std::size_t k = 0; k < 3; ++k)
        for (const std::size_t next : at_edge[{triangle[k], triangle[(k + 1) % 3]}])
          if (taken[next] == 0) {
            taken[next] = 1;
            front.push_back (next);
          }
    }
  }
  return parts;
}

bool
isOneSided (const SimplicialComplex& part)
{
  return !analyze (part).surface.components.front ().orientable;
}

// Neighbours agree on a direction in every part but those where they cannot.
bool
isOriented (const SimplicialComplex& shape)
{
  std::set<std::pair<pcl::index_t, pcl::index_t>> directed;
  for (const SimplicialComplex& part : partsOf (shape))
    if (!isOneSided (part))
      for (const auto& triangle : part.triangles)
        for (std::size_t k = 0; k < 3; ++k)
          if (!directed.insert ({triangle[k], triangle[(k + 1) % 3]}).second)
            return false;
  return true;
}

bool
isSame (const SimplicialComplex& a, const SimplicialComplex& b)
{
  return a.edges == b.edges && a.triangles == b.triangles && a.tetrahedra == b.tetrahedra;
}

SimplicialComplex
extract (const std::shared_ptr<const SampleSet>& samples, bool watertight)
{
  SampleDimensions dimensions =
    pcl::manifold::computeDimensions (pcl::manifold::computeDelaunayComplex (samples, 1), 0.3);
  pcl::manifold::decideManifoldDimensions (dimensions);
  StageLog log;
  return pcl::manifold::extractShape (dimensions, watertight, log);
}

// How many simplices of each dimension there were to look at.
using Counts = std::array<std::size_t, 4>;

void
expectPromises (const Eigen::Matrix3Xd& cloud, const std::string& name, int k, Counts& counts)
{
  const auto samples = std::make_shared<SampleSet> ();
  const Status status = pcl::manifold::makeSampleSet (cloud, {}, {k, 0.0}, 0x1p-53, *samples);
  if (status != Status::OK)
    return;
  for (const bool watertight : {false, true}) {
    const SimplicialComplex shape = extract (samples, watertight);
    EXPECT_EQ (brokenPromise (shape, *samples, watertight), "")
      << name << ", k " << k << (watertight ? ", watertight" : ", open");
    EXPECT_TRUE (isOriented (shape)) << name << ", k " << k;
    EXPECT_TRUE (analyze (shape).surface.isOrientable ()) << name << ", k " << k;
    counts[1] += shape.edges.size ();
    counts[2] += shape.triangles.size ();
    counts[3] += shape.tetrahedra.size ();
  }
}

TEST (Extraction, KeepsItsPromisesOnSmallClouds)
{
  Counts counts{};
  int round = 0;
  forEachCloud (45, 100, [&] (const Eigen::Matrix3Xd& cloud, const std::string& name) {
    expectPromises (cloud, name, ++round % 4 == 0 ? 4 : 0, counts);
  });
  EXPECT_GT (counts[1], 5000u);
  EXPECT_GT (counts[2], 50000u);
}

TEST (Extraction, KeepsItsPromisesOnLargerClouds)
{
  Counts counts{};
  forEachCloud (14, 600, [&] (const Eigen::Matrix3Xd& cloud, const std::string& name) {
    if (cloud.cols () > 100)
      expectPromises (cloud, name, 0, counts);
  });
  EXPECT_GT (counts[1], 1000u);
  EXPECT_GT (counts[2], 50000u);
  EXPECT_GT (counts[3], 10000u);
}

TEST (Extraction, IsTheSameForOneAndTwoThreads)
{
  forEachCloud (12, 200, [] (const Eigen::Matrix3Xd& cloud, const std::string& name) {
    const auto samples = std::make_shared<SampleSet> ();
    if (pcl::manifold::makeSampleSet (cloud, {}, {}, 0x1p-53, *samples) != Status::OK)
      return;
    for (const bool watertight : {false, true}) {
      SimplicialComplex shapes[2];
      for (unsigned int threads = 1; threads <= 2; ++threads)
        pcl::manifold::withThreads (threads, [&] { shapes[threads - 1] = extract (samples, watertight); });
      EXPECT_TRUE (isSame (shapes[0], shapes[1])) << name;
    }
  });
}

// By coordinates, because of duplicates any may stand for its point.
using Corners = std::vector<std::array<double, 3>>;

template <typename Cells>
void
addCorners (const Cells& cells, const Eigen::Matrix3Xd& cloud, std::vector<Corners>& corners)
{
  for (const auto& cell : cells) {
    corners.emplace_back ();
    for (const pcl::index_t vertex : cell)
      corners.back ().push_back ({cloud (0, vertex), cloud (1, vertex), cloud (2, vertex)});
  }
}

std::vector<Corners>
cornersOf (const SimplicialComplex& shape, const Eigen::Matrix3Xd& cloud)
{
  std::vector<Corners> corners;
  addCorners (shape.edges, cloud, corners);
  addCorners (shape.triangles, cloud, corners);
  addCorners (shape.tetrahedra, cloud, corners);
  return corners;
}

TEST (Extraction, DoesNotDependOnTheOrderOfTheInput)
{
  forEachCloud (12, 150, [] (const Eigen::Matrix3Xd& cloud, const std::string& name) {
    Random random (3);
    Eigen::Matrix3Xd shuffled = cloud;
    for (Eigen::Index i = cloud.cols (); i > 1; --i)
      shuffled.col (i - 1).swap (shuffled.col (random.index (static_cast<int> (i))));
    ShapeParameters parameters;
    parameters.dimension.threads = 1;
    parameters.watertight = random.coin ();
    SimplicialComplex shapes[2];
    Status status[2];
    for (int i = 0; i < 2; ++i) {
      StageLog log;
      std::shared_ptr<const SampleDimensions> dimensions;
      status[i] = pcl::manifold::reconstructShape (i == 0 ? cloud : shuffled, {}, 0x1p-53, parameters, log,
                                                   dimensions, shapes[i]);
      EXPECT_EQ (dimensions == nullptr, status[i] != Status::OK);
      EXPECT_TRUE (status[i] == Status::OK || shapes[i].empty ());
    }
    EXPECT_EQ (status[0], status[1]) << name;
    EXPECT_EQ (cornersOf (shapes[0], cloud), cornersOf (shapes[1], shuffled)) << name;
  });
}

} // namespace
