// The sample set against its description: what is kept, where it comes from, and that the order of the input
// does not matter.
#include "oracle_exact.h"
#include "oracle_lattice.h"

#include "common/parallel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>

namespace {

using namespace oracle;
using pcl::manifold::makeSampleSet;
using pcl::manifold::SampleSet;
using pcl::manifold::Status;
using pcl::manifold::Thinning;

constexpr double DOUBLES = 0x1p-53;
constexpr double FLOATS = 0x1p-24;
constexpr double NOT_A_NUMBER = std::numeric_limits<double>::quiet_NaN ();
constexpr double INFINITE_COORDINATE = std::numeric_limits<double>::infinity ();

SampleSet
samplesOf (const Eigen::Matrix3Xd& cloud, const Thinning& thinning = {}, const pcl::Indices& indices = {})
{
  SampleSet samples;
  EXPECT_EQ (makeSampleSet (cloud, indices, thinning, DOUBLES, samples), Status::OK);
  return samples;
}

Eigen::Matrix3Xd
randomCloud (Random& random, int size, const Eigen::Vector3d& scale, const Eigen::Vector3d& offset)
{
  Eigen::Matrix3Xd cloud (3, size);
  for (Eigen::Index i = 0; i < cloud.cols (); ++i)
    for (int axis = 0; axis < 3; ++axis)
      cloud (axis, i) = offset[axis] + scale[axis] * random.uniform (-1, 1);
  return cloud;
}

// With exact duplicates, points that are not finite, and zeros of both signs.
Eigen::Matrix3Xd
dirtyCloud (std::uint64_t seed)
{
  Random random (seed);
  const double size = std::ldexp (1.0, random.integer (-300, 300));
  const double offset = random.coin () ? 0.0 : std::ldexp (random.uniform (-1, 1), random.integer (0, 12));
  Eigen::Matrix3Xd cloud = randomCloud (random, random.integer (1, 60), Eigen::Vector3d::Constant (size),
                                        Eigen::Vector3d (1, -1, 0.5) * (offset * size));
  for (Eigen::Index i = 1; i < cloud.cols (); ++i) {
    const int what = random.index (8);
    if (what < 3)
      cloud.col (i) = cloud.col (random.index (static_cast<int> (i)));
    else if (what == 3)
      cloud (random.index (3), i) = random.coin () ? NOT_A_NUMBER : INFINITE_COORDINATE;
    else if (what == 4)
      cloud (random.index (3), i) = random.coin () ? 0.0 : -0.0;
  }
  return cloud;
}

Eigen::Matrix3Xd
shuffled (const Eigen::Matrix3Xd& cloud, std::uint64_t seed)
{
  Random random (seed);
  Eigen::Matrix3Xd result = cloud;
  for (Eigen::Index i = result.cols (); i > 1; --i)
    result.col (i - 1).swap (result.col (random.index (static_cast<int> (i))));
  return result;
}

std::array<double, 3>
keyOf (const Eigen::Vector3d& p)
{
  return {p.x () + 0.0, p.y () + 0.0, p.z () + 0.0}; // one zero only
}

TEST (SampleSet, KeepsEveryDistinctFinitePointOnce)
{
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    const Eigen::Matrix3Xd cloud = dirtyCloud (seed);
    pcl::Indices indices;
    for (Eigen::Index i = 0; i < cloud.cols () && seed % 2 == 1; ++i)
      indices.push_back (static_cast<pcl::index_t> (1000 - 3 * i));
    SampleSet samples;
    const Status status = makeSampleSet (cloud, indices, {}, DOUBLES, samples);
    std::map<std::array<double, 3>, pcl::index_t> first;
    std::size_t finite = 0;
    for (Eigen::Index i = 0; i < cloud.cols (); ++i)
      if (cloud.col (i).allFinite ()) {
        ++finite;
        first.emplace (keyOf (cloud.col (i)), indices.empty () ? static_cast<pcl::index_t> (i) : indices[i]);
      }
    ASSERT_EQ (status, finite == 0 ? Status::NO_INPUT : Status::OK);
    ASSERT_EQ (static_cast<std::size_t> (samples.size ()), first.size ()) << "seed " << seed << "\n" << cloud;
    ASSERT_EQ (samples.input_index.size (), first.size ());
    if (finite == 0)
      continue;
    ASSERT_EQ (samples.non_finite, static_cast<std::size_t> (cloud.cols ()) - finite);
    ASSERT_EQ (samples.duplicates, finite - first.size ());
    ASSERT_EQ (samples.thinned, 0u);
    ASSERT_EQ (samples.sample_of.size (), static_cast<std::size_t> (cloud.cols ()));
    for (Eigen::Index i = 0; i < cloud.cols (); ++i) {
      const std::int32_t sample = samples.sample_of[static_cast<std::size_t> (i)];
      ASSERT_EQ (sample >= 0, cloud.col (i).allFinite ());
      if (sample < 0)
        continue;
      ASSERT_EQ (samples.input_index[static_cast<std::size_t> (sample)], first.at (keyOf (cloud.col (i))));
      // (input - origin) * scale, exactly.
      for (int axis = 0; axis < 3; ++axis)
        ASSERT_TRUE (Rational (samples.points (axis, sample)) ==
                     (Rational (cloud (axis, i)) - Rational (samples.origin[axis])) *
                       Rational (samples.scale))
          << "seed " << seed;
    }
    int exponent = 0;
    ASSERT_EQ (std::frexp (samples.scale, &exponent), 0.5);
    const double extent =
      (samples.points.rowwise ().maxCoeff () - samples.points.rowwise ().minCoeff ()).maxCoeff ();
    if (first.size () > 1) {
      ASSERT_GE (extent, 1.0);
      ASSERT_LT (extent, 2.0);
    }
  }
}

TEST (SampleSet, DoesNotDependOnTheOrderOfTheInput)
{
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    const Eigen::Matrix3Xd cloud = dirtyCloud (seed);
    Thinning thinning;
    thinning.neighbors = static_cast<int> (seed % 3) * 2;
    thinning.distance = seed % 5 == 0 ? 0.1 : 0.0;
    SampleSet a, b;
    ASSERT_EQ (makeSampleSet (cloud, {}, thinning, DOUBLES, a),
               makeSampleSet (shuffled (cloud, seed), {}, thinning, DOUBLES, b));
    ASSERT_TRUE (a.points == b.points);
    ASSERT_TRUE (a.origin == b.origin);
    ASSERT_EQ (a.scale, b.scale);
  }
}

TEST (SampleSet, ShiftsACloudFarFromTheOrigin)
{
  Random random (1);
  Eigen::Matrix3Xd cloud = randomCloud (random, 100, {10, 10, 10}, {5e5, 4.5e6, 100});
  const SampleSet samples = samplesOf (cloud);
  EXPECT_GT (samples.origin.x (), 4e5);
  EXPECT_GT (samples.origin.y (), 4e6);
  EXPECT_LT (samples.points.cwiseAbs ().maxCoeff (), 16.0);
}

TEST (SampleSet, TakesCoordinatesOfAnySize)
{
  for (const double size : {1e-320, 1e-300, 1e-200, 1e-45, 1e-38, 1e-30, 1.0, 1e30, 1e38, 1e39, 1e200, 1e300})
    for (const double offset : {0.0, 1.0, 40.0, 1e5}) {
      Random random (3);
      const Eigen::Matrix3Xd cloud = randomCloud (random, 50, Eigen::Vector3d::Constant (size),
                                                  Eigen::Vector3d (1, -1, 1) * (offset * size));
      const SampleSet samples = samplesOf (cloud);
      ASSERT_TRUE (samples.points.allFinite ()) << size << " " << offset;
      ASSERT_TRUE (samples.origin.allFinite ()) << size << " " << offset;
      ASSERT_GT (samples.size (), size > 1e-310 ? 49 : 1) << size << " " << offset;
      for (int axis = 0; axis < 3; ++axis)
        for (std::int32_t i = 0; i < samples.size (); ++i)
          ASSERT_TRUE (Rational (samples.points (axis, i)) ==
                       (Rational (cloud (axis, samples.input_index[static_cast<std::size_t> (i)])) -
                        Rational (samples.origin[axis])) *
                         Rational (samples.scale))
            << size << " " << offset;
    }
}

TEST (SampleSet, OfOnePointAnywhere)
{
  for (const double x : {0.0, -0.0, 1e-320, 0.1, 1e30, 1e300, -1.7e308}) {
    Eigen::Matrix3Xd cloud (3, 3);
    cloud.setConstant (x);
    const SampleSet samples = samplesOf (cloud);
    EXPECT_EQ (samples.size (), 1);
    EXPECT_EQ (samples.duplicates, 2u);
    EXPECT_TRUE (samples.points.allFinite ()) << x;
  }
}

TEST (SampleSet, SaysWhyThereIsNone)
{
  SampleSet samples;
  EXPECT_EQ (makeSampleSet (Eigen::Matrix3Xd (3, 0), {}, {}, DOUBLES, samples), Status::NO_INPUT);
  EXPECT_EQ (makeSampleSet (Eigen::Vector3d (0, NOT_A_NUMBER, 0), {}, {}, DOUBLES, samples),
             Status::NO_INPUT);
  Eigen::Matrix3Xd cloud = Eigen::Matrix3Xd::Identity (3, 3);
  for (const Thinning& thinning :
       {Thinning{-1, 0.0}, Thinning{0, -1.0}, Thinning{0, NOT_A_NUMBER}, Thinning{0, INFINITE_COORDINATE}})
    EXPECT_EQ (makeSampleSet (cloud, {}, thinning, DOUBLES, samples), Status::PARAMETER_OUT_OF_RANGE);
  cloud *= 1.7e308;
  cloud.col (2) *= -1.0;
  EXPECT_EQ (makeSampleSet (cloud, {}, {}, DOUBLES, samples), Status::OK);
  cloud.col (1) = -cloud.col (0);
  EXPECT_EQ (makeSampleSet (cloud, {}, {}, DOUBLES, samples), Status::INPUT_OUT_OF_RANGE);
  EXPECT_EQ (samples.size (), 0);
  EXPECT_TRUE (samples.sample_of.empty ());
}

// A scan of a sphere with a spacing of about 0.05, in floats.
TEST (SampleSet, ReportsFloatsThatCannotResolveTheirSpacing)
{
  Random random (5);
  Eigen::Matrix3Xd sphere = randomCloud (random, 5000, {1, 1, 1}, {0, 0, 0});
  sphere.colwise ().normalize ();
  const auto statusAt = [&sphere] (double radius, double offset, double resolution) {
    Eigen::Matrix3Xd cloud = radius * sphere;
    cloud.colwise () += Eigen::Vector3d (0.11 * offset, offset, 0);
    if (resolution == FLOATS)
      cloud = cloud.cast<float> ().cast<double> ();
    SampleSet samples;
    return makeSampleSet (cloud, {}, {}, resolution, samples);
  };
  EXPECT_EQ (statusAt (1, 4.5e6, FLOATS), Status::INPUT_TOO_COARSE);
  EXPECT_EQ (statusAt (1, 4.5e6, DOUBLES), Status::OK);
  EXPECT_EQ (statusAt (1000, 4.5e6, FLOATS), Status::OK);
  EXPECT_EQ (statusAt (1, 0, FLOATS), Status::OK);
  EXPECT_EQ (statusAt (1, 1e3, FLOATS), Status::OK);
  EXPECT_EQ (statusAt (1e-30, 4.5e-24, FLOATS), Status::INPUT_TOO_COARSE);
}

// Squared distances of all pairs.
Eigen::MatrixXd
distances (const Eigen::Matrix3Xd& points)
{
  Eigen::MatrixXd result (points.cols (), points.cols ());
  for (Eigen::Index i = 0; i < points.cols (); ++i)
    result.col (i) = (points.colwise () - points.col (i)).colwise ().squaredNorm ();
  return result;
}

// The kept samples of a thinned set as a flag per sample of the set without thinning.
std::vector<bool>
keptOf (const SampleSet& all, const SampleSet& thinned)
{
  std::vector<bool> kept (static_cast<std::size_t> (all.size ()), false);
  for (std::int32_t i = 0, j = 0; i < all.size () && j < thinned.size (); ++i)
    if (all.points.col (i) == thinned.points.col (j)) {
      kept[static_cast<std::size_t> (i)] = true;
      ++j;
    }
  EXPECT_EQ (std::count (kept.begin (), kept.end (), true), thinned.size ());
  EXPECT_EQ (thinned.thinned, static_cast<std::size_t> (all.size () - thinned.size ()));
  return kept;
}

// No two kept ones conflict, and every other one conflicts with a kept one.
template <typename Conflict>
void
expectMaximal (const std::vector<bool>& kept, const Conflict& certain, const Conflict& possible)
{
  for (std::size_t i = 0; i < kept.size (); ++i) {
    bool conflicts = kept[i];
    for (std::size_t j = 0; j < kept.size (); ++j) {
      if (i == j || !kept[j])
        continue;
      ASSERT_FALSE (kept[i] && certain (i, j)) << i << " " << j;
      conflicts = conflicts || possible (i, j);
    }
    ASSERT_TRUE (conflicts) << i;
  }
}

void
expectNearestKept (const SampleSet& all, const SampleSet& thinned)
{
  for (std::size_t i = 0; i < all.sample_of.size (); ++i) {
    const Eigen::Vector3d p = all.points.col (all.sample_of[i]);
    const double distance = (p - thinned.points.col (thinned.sample_of[i])).norm ();
    ASSERT_LE (distance, (thinned.points.colwise () - p).colwise ().norm ().minCoeff () * (1.0 + 1e-12)) << i;
  }
}

using Conflict = std::function<bool (std::size_t, std::size_t)>;

TEST (SampleSet, ThinsByNeighbors)
{
  forEachLattice (12, 1, 80, [] (const Eigen::Matrix3Xd& cloud, int kind) {
    const SampleSet all = samplesOf (cloud);
    const Eigen::MatrixXd squared = distances (all.points);
    for (const int k : {1, 2, 6, 24, 200}) {
      const SampleSet thinned = samplesOf (cloud, {k, 0.0});
      const std::vector<bool> kept = keptOf (all, thinned);
      // Among equally far ones any may be taken for the k nearest.
      std::vector<double> reach;
      for (Eigen::Index i = 0; i < squared.cols (); ++i) {
        std::vector<double> row (squared.col (i).data (), squared.col (i).data () + squared.rows ());
        std::sort (row.begin (), row.end ());
        reach.push_back (row[std::min<std::size_t> (static_cast<std::size_t> (k), row.size () - 1)]);
      }
      const double rounding = 1e-12;
      const Conflict certain = [&] (std::size_t i, std::size_t j) {
        return squared (i, j) < std::max (reach[i], reach[j]) * (1.0 - rounding);
      };
      const Conflict possible = [&] (std::size_t i, std::size_t j) {
        return squared (i, j) <= std::max (reach[i], reach[j]) * (1.0 + rounding);
      };
      SCOPED_TRACE ("kind " + std::to_string (kind) + ", k " + std::to_string (k));
      expectMaximal (kept, certain, possible);
      expectNearestKept (all, thinned);
      if (testing::Test::HasFatalFailure ())
        return;
    }
  });
}

TEST (SampleSet, ThinsBySpacing)
{
  forEachLattice (12, 1, 80, [] (const Eigen::Matrix3Xd& cloud, int kind) {
    const SampleSet all = samplesOf (cloud);
    const Eigen::MatrixXd squared = distances (all.points);
    for (const double share : {1e-30, 1e-17, 1e-14, 1e-6, 0.01, 0.1, 0.5, 1.0, 10.0, 1e30}) {
      const double spacing = share / all.scale;
      const SampleSet thinned = samplesOf (cloud, {0, spacing});
      const std::vector<bool> kept = keptOf (all, thinned);
      const Conflict certain = [&] (std::size_t i, std::size_t j) {
        return std::sqrt (squared (i, j)) < share * (1.0 - 1e-9);
      };
      const Conflict possible = [&] (std::size_t i, std::size_t j) {
        return std::sqrt (squared (i, j)) < share * (1.0 + 1e-9);
      };
      SCOPED_TRACE ("kind " + std::to_string (kind) + ", spacing " + std::to_string (share));
      expectMaximal (kept, certain, possible);
      expectNearestKept (all, thinned);
      if (testing::Test::HasFatalFailure ())
        return;
    }
  });
}

TEST (SampleSet, ThinsByBoth)
{
  forEachLattice (12, 1, 80, [] (const Eigen::Matrix3Xd& cloud, int kind) {
    const SampleSet all = samplesOf (cloud);
    const SampleSet thinned = samplesOf (cloud, {3, 0.1 / all.scale});
    SCOPED_TRACE ("kind " + std::to_string (kind));
    keptOf (all, thinned);
    expectNearestKept (all, thinned);
  });
}

TEST (SampleSet, ThinsByVerySmallSpacings)
{
  Random random (9);
  const Eigen::Matrix3Xd cloud = randomCloud (random, 100, {1e20, 1e20, 1e20}, {0, 0, 0});
  for (const double spacing : {5e-324, 1e-300, 1e-30, 1.0, 1e5})
    EXPECT_EQ (samplesOf (cloud, {0, spacing}).size (), 100) << spacing;
}

TEST (SampleSet, IsTheSameForOneAndTwoThreads)
{
  Random random (13);
  const Eigen::Matrix3Xd cloud = randomCloud (random, 20000, {1, 1, 0.01}, {0, 0, 0});
  for (const Thinning& thinning :
       {Thinning{0, 0.0}, Thinning{8, 0.0}, Thinning{0, 0.02}, Thinning{4, 0.01}}) {
    SampleSet samples[2];
    for (unsigned int threads = 1; threads <= 2; ++threads)
      pcl::manifold::withThreads (threads, [&] { samples[threads - 1] = samplesOf (cloud, thinning); });
    EXPECT_TRUE (samples[0].points == samples[1].points);
    EXPECT_EQ (samples[0].input_index, samples[1].input_index);
    EXPECT_EQ (samples[0].sample_of, samples[1].sample_of);
  }
}

} // namespace
