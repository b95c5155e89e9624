// The manifold fixed-point complex against its definition.
#include "oracle_restriction_dag.h"

#include "common/parallel.h"

#include <pcl/manifold/fixed_point_complex.h>

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace {

using namespace oracle;
using pcl::manifold::computeFixedPointComplex;
using pcl::manifold::CriticalPointParameters;
using pcl::manifold::DelaunayComplex;
using pcl::manifold::FixedPoint;
using pcl::manifold::fixedPoint;
using pcl::manifold::FixedPointComplex;
using pcl::manifold::restrictedDelaunay;
using pcl::manifold::StageLog;
using pcl::manifold::Status;
using pcl::manifold::withThreads;

constexpr int ROUNDS = 80;

TEST (FixedPointComplex, IsWhatDescendsFromManifoldAnchoredTriangles)
{
  std::size_t medial = 0;
  std::size_t chained = 0;
  forEachDag (ROUNDS, [&] (const DelaunayComplex& complex, const NaiveDag& dag, Random& random) {
    CriticalPointParameters parameters;
    parameters.ratio = random.uniform (0.05, 1.0);
    parameters.votes = 1 + random.index (3);
    StageLog log;
    FixedPointComplex result;
    ASSERT_EQ (computeFixedPointComplex (complex, parameters, log, result), Status::OK);
    Set manifold (dag.size ());
    std::size_t counts[4] = {0, 0, 0, 0};
    for (std::size_t i = 0; i < dag.size (); ++i) {
      const auto has = [&] (const FacetFlags& flags) {
        return flags.contains (dag.oracle.facets[i].cell, dag.oracle.facets[i].facet);
      };
      ASSERT_EQ (dag.isAnchored (i), has (result.manifold) != has (result.medial));
      manifold[i] = has (result.manifold) ? 1 : 0;
      counts[0] += dag.isAnchored (i) ? 1 : 0;
      counts[1] += has (result.medial) ? 1 : 0;
      counts[2] += has (result.facets) && !has (result.manifold) ? 1 : 0;
    }
    ASSERT_TRUE (result.facets == dag.flagsOf (complex, dag.closure (manifold)));
    ASSERT_EQ (result.anchored, counts[0]);
    ASSERT_EQ (result.medial_anchored, counts[1]);
    ASSERT_EQ (result.chained, counts[2]);
    // It is a fixed point itself.
    ASSERT_TRUE (restrictedDelaunay (complex, result.facets) == result.facets);
    medial += result.medial_anchored;
    chained += result.chained;
  });
  EXPECT_GT (medial, 500u);
  EXPECT_GT (chained, 500u);
}

TEST (FixedPointComplex, RefusesBadParametersAndCanBeCancelled)
{
  const auto complex = complexOf (latticeCloud (Lattice::SPHERE, 50, 1));
  FixedPointComplex result;
  StageLog log;
  const auto statusOf = [&] (double ratio, int votes) {
    return computeFixedPointComplex (*complex, {ratio, votes}, log, result);
  };
  ASSERT_EQ (statusOf (0.6, 2), Status::OK);
  EXPECT_FALSE (result.facets.mask.empty ());
  for (const double ratio : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN ()})
    EXPECT_EQ (statusOf (ratio, 2), Status::PARAMETER_OUT_OF_RANGE);
  for (const int votes : {0, -1, 4})
    EXPECT_EQ (statusOf (0.6, votes), Status::PARAMETER_OUT_OF_RANGE);
  EXPECT_TRUE (result.facets.mask.empty ());
  for (int calls = 0; calls < 4; ++calls) {
    int left = calls;
    StageLog cancelled ([&left] (float) { return left-- > 0; });
    EXPECT_EQ (computeFixedPointComplex (*complex, {0.6, 2}, cancelled, result), Status::CANCELLED) << calls;
    EXPECT_TRUE (result.facets.mask.empty () && result.anchored == 0);
  }
}

TEST (FixedPointComplex, DoesNotDependOnThreads)
{
  const auto complex = complexOf (latticeCloud (Lattice::BALL, 3000, 3));
  FixedPointComplex results[2];
  FixedPoint fixed[2];
  for (unsigned int threads = 1; threads <= 2; ++threads)
    withThreads (threads, [&] {
      StageLog log;
      ASSERT_EQ (computeFixedPointComplex (*complex, {0.5, 2}, log, results[threads - 1]), Status::OK);
      fixed[threads - 1] = fixedPoint (*complex, results[threads - 1].medial);
    });
  EXPECT_TRUE (results[0].facets == results[1].facets);
  EXPECT_TRUE (results[0].medial == results[1].medial);
  EXPECT_EQ (results[0].chained, results[1].chained);
  EXPECT_TRUE (fixed[0].facets == fixed[1].facets);
  EXPECT_EQ (fixed[0].iterations, fixed[1].iterations);
  EXPECT_GT (results[0].chained, 100u);
}

} // namespace
