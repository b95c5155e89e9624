// The flat arrays of the Delaunay complex against the definition of a Delaunay triangulation.
#include "oracle_complex.h"
#include "oracle_lattice.h"

#include "common/parallel.h"

#include <gtest/gtest.h>

#include <cmath>

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

// Enough samples for the insertion in parallel. The grid is as degenerate as can be.
class LargeCloud : public testing::TestWithParam<int>
{};

Eigen::Matrix3Xd
largeCloud (int kind)
{
  constexpr int N = 52000;
  Random random (11);
  Eigen::Matrix3Xd cloud (3, kind == 1 ? 40 * 40 * 33 : N);
  for (Eigen::Index i = 0; i < cloud.cols (); ++i) {
    Eigen::Vector3d p (random.uniform (-1, 1), random.uniform (-1, 1), random.uniform (-1, 1));
    if (kind == 1) // a grid
      p = Eigen::Vector3d (static_cast<double> (i % 40), static_cast<double> (i / 40 % 40),
                           static_cast<double> (i / 1600));
    else if (kind == 2) // a sphere
      p.normalize ();
    cloud.col (i) = p;
  }
  return cloud;
}

TEST_P (LargeCloud, IsTheSameForOneAndTwoThreads)
{
  const auto samples = samplesOf (largeCloud (GetParam ()));
  std::shared_ptr<const DelaunayComplex> complexes[2];
  for (unsigned int threads = 1; threads <= 2; ++threads)
    pcl::manifold::withThreads (
      threads, [&] { complexes[threads - 1] = computeDelaunayComplex (samples, threads); });
  expectSame (*complexes[0], *complexes[1]);
  EXPECT_EQ (brokenArrays (*complexes[0]), "");
  EXPECT_EQ (brokenNeighbors (*complexes[0]), "");
}

INSTANTIATE_TEST_SUITE_P (DelaunayComplex, LargeCloud, testing::Range (0, 3));

} // namespace
