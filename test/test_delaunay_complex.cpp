// The flat arrays of the Delaunay complex against the definition of a Delaunay triangulation.
#include "oracle_complex.h"
#include "oracle_lattice.h"

#include "common/parallel.h"
#include "delaunay/flat_complex.h"
#include <pcl/manifold/detail/guarded.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace {

using namespace oracle;
using pcl::manifold::computeDelaunayComplex;
using pcl::manifold::makeSampleSet;
using pcl::manifold::SampleSet;
using pcl::manifold::Status;

std::shared_ptr<const SampleSet>
samplesOf (const Eigen::Matrix3Xd& cloud)
{
  auto samples = std::make_shared<SampleSet> ();
  EXPECT_EQ (makeSampleSet (cloud, {}, {}, 0x1p-53, *samples), Status::OK);
  return samples;
}

void
expectSame (const DelaunayComplex& a, const DelaunayComplex& b)
{
  EXPECT_EQ (a.affine_dimension, b.affine_dimension);
  EXPECT_EQ (a.finite_cells, b.finite_cells);
  EXPECT_TRUE (a.cells == b.cells);
  EXPECT_TRUE (a.neighbors == b.neighbors);
  EXPECT_TRUE (a.centers == b.centers);
  EXPECT_TRUE (a.incident_offsets == b.incident_offsets);
  EXPECT_TRUE (a.incident_cells == b.incident_cells);
  EXPECT_TRUE (a.line == b.line);
}

TEST (DelaunayComplex, OnePoint)
{
  const auto complex = complexOf (Eigen::Vector3d (1, 2, 3));
  EXPECT_EQ (complex->affine_dimension, 0);
  EXPECT_TRUE (complex->cells.empty ());
  EXPECT_EQ (complex->line, std::vector<std::int32_t>{0});
}

TEST (DelaunayComplex, OneTriangleHasTwoSides)
{
  Eigen::Matrix3Xd cloud (3, 3);
  cloud << 0, 4, 0, 0, 0, 4, 0, 0, 0;
  const auto complex = complexOf (cloud);
  EXPECT_EQ (complex->affine_dimension, 2);
  EXPECT_EQ (complex->cells.size (), 2u);
  EXPECT_EQ (brokenPromise<Integer> (*complex), "");
}

TEST (DelaunayComplex, OneTetrahedron)
{
  Eigen::Matrix3Xd cloud (3, 4);
  cloud << 0, 4, 0, 0, 0, 0, 4, 0, 0, 0, 0, 4;
  const auto complex = complexOf (cloud);
  EXPECT_EQ (complex->finite_cells, 1);
  EXPECT_EQ (complex->cells.size (), 5u);
  EXPECT_TRUE (complex->centers.col (0) == Eigen::Vector3d (2, 2, 2));
  EXPECT_EQ (brokenPromise<Integer> (*complex), "");
}

TEST (DelaunayComplex, KeepsItsPromisesOnEveryKindOfCloud)
{
  forEachLattice (150, 2, 40, [] (const Eigen::Matrix3Xd& cloud, int kind) {
    ASSERT_EQ (brokenPromise<Integer> (*complexOf (cloud)), "") << "kind " << kind << "\n" << cloud;
  });
}

// The oracle itself: it sees what is not a Delaunay complex.
TEST (DelaunayComplex, OracleSeesWhatIsBroken)
{
  const auto complex = complexOf (latticeCloud (Lattice::GENERIC, 20, 1));
  ASSERT_EQ (brokenPromise<Integer> (*complex), "");
  const auto isBroken = [&complex] (const auto& breakIt) {
    DelaunayComplex other = *complex;
    breakIt (other);
    return !brokenPromise<Integer> (other).empty ();
  };
  EXPECT_TRUE (isBroken ([] (DelaunayComplex& c) { c.affine_dimension = 2; }));
  EXPECT_TRUE (isBroken ([] (DelaunayComplex& c) { ++c.finite_cells; }));
  EXPECT_TRUE (isBroken ([] (DelaunayComplex& c) { c.incident_cells.pop_back (); }));
  EXPECT_TRUE (isBroken ([] (DelaunayComplex& c) { std::swap (c.cells[3][0], c.cells[3][1]); }));
  EXPECT_TRUE (isBroken ([] (DelaunayComplex& c) {
    std::swap (c.cells[3][0], c.cells[3][1]);
    std::swap (c.neighbors[3][0], c.neighbors[3][1]);
  }));
  EXPECT_TRUE (isBroken ([] (DelaunayComplex& c) { std::swap (c.neighbors[3][0], c.neighbors[3][1]); }));
  EXPECT_TRUE (isBroken ([] (DelaunayComplex& c) { c.centers.col (3) *= 1.001; }));
  EXPECT_TRUE (isBroken ([] (DelaunayComplex& c) { c.centers.col (c.finite_cells) *= -1.0; }));
  EXPECT_TRUE (isBroken ([] (DelaunayComplex& c) {
    // A sample moved into the middle of the others.
    auto samples = std::make_shared<SampleSet> (*c.samples);
    samples->points.col (0) = (c.samples->points.rowwise ().mean ()).array ().round ();
    c.samples = samples;
  }));
}

// Coordinates of any size: the sample set scales, the predicates are exact.
TEST (DelaunayComplex, KeepsItsPromisesOnExtremeCoordinates)
{
  for (int round = 0; round < 60; ++round) {
    Random random (static_cast<std::uint64_t> (round));
    Eigen::Matrix3Xd cloud (3, random.integer (5, 14));
    Eigen::Vector3d scale;
    for (double& s : scale)
      s = std::ldexp (1.0, random.integer (-40, 40));
    scale *= round % 3 == 0 ? 1e30 : (round % 3 == 1 ? 1e-30 : 1.0);
    for (Eigen::Index i = 0; i < cloud.cols (); ++i)
      for (int axis = 0; axis < 3; ++axis)
        cloud (axis, i) = scale[axis] * random.uniform (-1, 1);
    const auto complex = computeDelaunayComplex (samplesOf (cloud), 1);
    ASSERT_EQ (brokenPromise<Rational> (*complex), "") << "round " << round;
  }
}

TEST (DelaunayComplex, DoesNotDependOnTheOrderOfTheInput)
{
  forEachLattice (40, 2, 60, [] (const Eigen::Matrix3Xd& cloud, int kind) {
    Random random (7);
    Eigen::Matrix3Xd shuffled = cloud;
    for (Eigen::Index i = cloud.cols (); i > 1; --i)
      shuffled.col (i - 1).swap (shuffled.col (random.index (static_cast<int> (i))));
    const auto a = computeDelaunayComplex (samplesOf (cloud), 1);
    const auto b = computeDelaunayComplex (samplesOf (shuffled), 1);
    ASSERT_TRUE (a->samples->points == b->samples->points) << "kind " << kind;
    expectSame (*a, *b);
  });
}

// Samples for an insertion in parallel, of several kinds: threads wait for each other, and fall back to one
// where the samples are still of a lower dimension.
Eigen::Matrix3Xd
largeCloud (const std::string& kind)
{
  Random random (11);
  Eigen::Matrix3Xd cloud (3, 30000);
  for (Eigen::Index i = 0; i < cloud.cols (); ++i) {
    Eigen::Vector3d p (random.uniform (-1, 1), random.uniform (-1, 1), random.uniform (-1, 1));
    if (kind == "grid")
      p = Eigen::Vector3d (static_cast<double> (i % 30), static_cast<double> (i / 30 % 40),
                           static_cast<double> (i / 1200));
    else if (kind == "sphere")
      p.normalize ();
    else if (kind == "plane")
      p.z () = 0;
    else if (kind == "plane_grid")
      p = Eigen::Vector3d (static_cast<double> (i % 100), 0, static_cast<double> (i / 100));
    else if (kind == "line")
      p = Eigen::Vector3d (0, 2 * p.x (), p.x ());
    else if (kind == "plane_and_one")
      p.z () = i == 5000 ? 0.5 : 0.0;
    cloud.col (i) = p;
  }
  return cloud;
}

TEST (DelaunayComplex, SaysWhenThereAreMoreCellsThanNumbers)
{
  Random random (3);
  for (const bool flat : {false, true}) {
    Eigen::Matrix3Xd cloud (3, 40);
    for (double& value : cloud.reshaped ())
      value = random.uniform ();
    if (flat)
      cloud.row (2).setZero ();
    const auto samples = samplesOf (cloud);
    const std::uint64_t cells = pcl::manifold::triangulate (*samples, false).vertices.size ();
    EXPECT_EQ (pcl::manifold::triangulate (*samples, false, cells).vertices.size (), cells);
    EXPECT_THROW (pcl::manifold::triangulate (*samples, false, cells - 1), std::length_error);
    EXPECT_EQ (pcl::manifold::guarded ([&] {
                 pcl::manifold::triangulate (*samples, false, cells - 1);
                 return pcl::manifold::Status::OK;
               }),
               pcl::manifold::Status::TOO_MANY_POINTS);
  }
  // What is counted per corner of a cell has room for all that the cells' own numbers allow.
  using Offset = decltype (DelaunayComplex::incident_offsets)::value_type;
  static_assert (std::numeric_limits<Offset>::max () >=
                 4 * static_cast<std::int64_t> (std::numeric_limits<std::int32_t>::max ()));
}

class LargeCloud : public testing::TestWithParam<const char*>
{};

TEST_P (LargeCloud, IsTheSameInsertedInParallel)
{
  const auto samples = samplesOf (largeCloud (GetParam ()));
  std::shared_ptr<const DelaunayComplex> complexes[2];
  for (const bool parallel : {false, true})
    pcl::manifold::withThreads (parallel ? 2 : 1, [&] {
      complexes[parallel ? 1 : 0] =
        pcl::manifold::makeDelaunayComplex (samples, pcl::manifold::triangulate (*samples, parallel));
    });
  expectSame (*complexes[0], *complexes[1]);
  EXPECT_EQ (brokenArrays (*complexes[0]), "");
  EXPECT_EQ (brokenNeighbors (*complexes[0]), "");
}

INSTANTIATE_TEST_SUITE_P (DelaunayComplex, LargeCloud,
                          testing::Values ("cube", "grid", "sphere", "plane", "plane_grid", "line",
                                           "plane_and_one"),
                          [] (const auto& instance) { return instance.param; });

} // namespace
