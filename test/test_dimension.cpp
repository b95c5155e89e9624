// DIMENSION with the heights of the half-space oracle, and what is decided from its labels.
#include "oracle_lattice.h"
#include "oracle_voronoi.h"

#include "voronoi/dimension.h"

#include <gtest/gtest.h>

#include <optional>

namespace {

using namespace oracle;
using pcl::manifold::computeDimensions;
using pcl::manifold::decideManifoldDimensions;
using pcl::manifold::SampleDimensions;

// H1, H2, H3 and the pole of V3, where all poles are sure.
struct Expected
{
  std::array<double, 3> heights;
  Eigen::Vector3d normal;
};

std::optional<Expected>
expectedHeights (const Eigen::Matrix3Xd& cloud, int sample)
{
  const VoronoiOracle cell = voronoiCell (cloud, sample);
  const Pole v3 = poleOfV3 (cell);
  if (!v3.direction_is_sure)
    return {};
  const Pole v2 = poleOfV2 (cell, v3.direction);
  if (!v2.direction_is_sure)
    return {};
  const Pole v1 = poleOfV1 (cell, v3.direction.cross (v2.direction).normalized ());
  if (!v1.height_is_sure)
    return {};
  return Expected{
    {static_cast<double> (v1.height), static_cast<double> (v2.height), static_cast<double> (v3.height)},
    v3.direction.cast<double> ()};
}

struct Answer
{
  int dimension;
  double confidence;
  double margin; ///< the smallest distance of a ratio from rho
};

// The loop of section 4, and how far it was from another answer: 0 at rho, 1 as far as a ratio can be.
Answer
expectedAnswer (const std::array<double, 3>& heights, double rho)
{
  Answer answer{3, 1.0, 1.0};
  while (answer.dimension > 1) {
    const double hi = heights[static_cast<std::size_t> (answer.dimension) - 1];
    const double ratio = std::isinf (hi) ? 0.0 : heights[0] / hi;
    answer.margin = std::min (answer.margin, std::abs (ratio - rho));
    if (ratio < rho) {
      answer.confidence = std::min (answer.confidence, (rho - ratio) / rho);
      --answer.dimension;
    } else {
      answer.confidence = std::min (answer.confidence, rho < 1.0 ? (ratio - rho) / (1.0 - rho) : 0.0);
      break;
    }
  }
  return answer;
}

void
expectHeight (double result, double expected)
{
  if (std::isinf (expected))
    ASSERT_TRUE (std::isinf (result));
  else
    ASSERT_NEAR (result, expected, 1e-4 * expected);
}

// How many samples got each label.
using Labels = std::array<int, 4>;

void
compareSample (const SampleDimensions& result, int sample, const Expected& expected, double rho,
               Labels& labels)
{
  const auto i = static_cast<std::size_t> (sample);
  for (int h = 0; h < 3; ++h)
    expectHeight (result.heights (h, sample), expected.heights[static_cast<std::size_t> (h)]);
  ASSERT_LT ((result.normals.col (sample) - expected.normal).norm (), 1e-5);
  const Answer answer = expectedAnswer (expected.heights, rho);
  if (answer.margin < 1e-3 * rho && rho < 1.0)
    return;
  ++labels[static_cast<std::size_t> (answer.dimension)];
  ASSERT_EQ (result.dimension[i], answer.dimension);
  ASSERT_NEAR (result.confidence[i], answer.confidence, 1e-2);
}

TEST (Dimension, IsThatOfTheLoop)
{
  Labels labels{};
  forEachLattice (40, 4, 24, [&] (const Eigen::Matrix3Xd& cloud, int kind) {
    const auto complex = complexOf (cloud);
    if (complex->affine_dimension != 3)
      return;
    std::vector<std::optional<Expected>> expected;
    for (int i = 0; i < static_cast<int> (cloud.cols ()); ++i)
      expected.push_back (expectedHeights (cloud, i));
    for (const double rho : {0.1, 0.3, 0.8, 1.0}) {
      const SampleDimensions result = computeDimensions (complex, rho);
      for (std::size_t i = 0; i < expected.size (); ++i) {
        // Where V1 is unbounded nothing can be told from the ratios.
        if (!expected[i] || std::isinf (expected[i]->heights[0]) || testing::Test::HasFatalFailure ())
          continue;
        SCOPED_TRACE (testing::Message () << "kind " << kind << ", rho " << rho << ", sample " << i << " of\n"
                                          << cloud);
        compareSample (result, static_cast<int> (i), *expected[i], rho, labels);
      }
    }
  });
  for (const std::size_t dimension : {1, 2, 3})
    EXPECT_GT (labels[dimension], 500) << dimension;
}

TEST (Dimension, IsNoMoreThanThatOfTheAffineHull)
{
  forEachLattice (40, 1, 40, [&] (const Eigen::Matrix3Xd& cloud, int kind) {
    const auto complex = complexOf (cloud);
    SampleDimensions result = computeDimensions (complex, 0.3);
    decideManifoldDimensions (result);
    for (std::size_t i = 0; i < result.dimension.size (); ++i) {
      ASSERT_LE (result.dimension[i], complex->affine_dimension) << kind;
      ASSERT_GE (result.dimension[i], std::min (complex->affine_dimension, 1)) << kind;
      ASSERT_LE (result.manifold_dimension[i], complex->affine_dimension) << kind;
      ASSERT_GE (result.confidence[i], 0.0f) << kind;
      ASSERT_LE (result.confidence[i], 1.0f) << kind;
    }
  });
}

TEST (Dimension, OfALine)
{
  Eigen::Matrix3Xd cloud (3, 4);
  cloud << 3, 0, 10, 1, 6, 0, 20, 2, 0, 0, 0, 0;
  SampleDimensions result = computeDimensions (complexOf (cloud), 0.3);
  decideManifoldDimensions (result);
  const double step = std::sqrt (5.0);
  EXPECT_DOUBLE_EQ (result.heights (0, 0), 3.5 * step);
  EXPECT_TRUE (std::isinf (result.heights (0, 1)));
  EXPECT_TRUE (std::isinf (result.heights (0, 2)));
  EXPECT_DOUBLE_EQ (result.heights (0, 3), step);
  EXPECT_EQ (result.dimension, std::vector<std::uint8_t> (4, 1));
  EXPECT_EQ (result.manifold_dimension, std::vector<std::uint8_t> (4, 1));
  EXPECT_EQ (result.boundary, (std::vector<std::uint8_t>{0, 1, 1, 0}));
  for (Eigen::Index i = 0; i < 4; ++i) {
    EXPECT_NEAR (std::abs (result.tangents.col (i).dot (Eigen::Vector3d (1, 2, 0))), step, 1e-12);
    EXPECT_NEAR (result.normals.col (i).dot (result.tangents.col (i)), 0.0, 1e-12);
  }
}

TEST (Dimension, OfOnePoint)
{
  SampleDimensions result = computeDimensions (complexOf (Eigen::Vector3d (1, 2, 3)), 0.3);
  decideManifoldDimensions (result);
  EXPECT_EQ (result.dimension, std::vector<std::uint8_t>{0});
  EXPECT_EQ (result.boundary, std::vector<std::uint8_t>{0});
}

// Inside of a plane DIMENSION answers 2 by the planar Voronoi cell; a square grid has square ones.
TEST (Dimension, OfAPlanarGrid)
{
  Eigen::Matrix3Xd cloud (3, 100);
  for (int i = 0; i < 100; ++i)
    cloud.col (i) = Eigen::Vector3d (i / 10, i % 10, 0);
  const SampleDimensions result = computeDimensions (complexOf (cloud), 0.3);
  for (int i = 0; i < 100; ++i) {
    const bool inner = i / 10 % 9 != 0 && i % 10 % 9 != 0;
    EXPECT_EQ (result.dimension[static_cast<std::size_t> (i)], inner ? 2 : 1) << i;
    if (inner) {
      EXPECT_NEAR (result.heights (1, i), std::sqrt (0.5), 1e-12);
      EXPECT_NEAR (result.heights (0, i), std::sqrt (0.5), 1e-12);
    }
  }
}

} // namespace
