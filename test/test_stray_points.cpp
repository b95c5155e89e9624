// What is no point of the shape: rays without measurement, which are left out, and strays, which change
// nothing for the others.
#include "oracle_random.h"

#include "points/thinning.h"
#include <pcl/manifold/bulk_box.h>
#include <pcl/manifold/sample_set.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

using oracle::Random;
using pcl::manifold::bulkBox;
using pcl::manifold::makeSampleSet;
using pcl::manifold::SampleSet;
using pcl::manifold::Status;

constexpr double DOUBLES = 0x1p-53;
constexpr double FLOATS = 0x1p-24;
constexpr double PI = 3.141592653589793;

Eigen::Matrix3Xd
sphere (int size, const Eigen::Vector3d& center = Eigen::Vector3d::Zero ())
{
  Random random (7);
  Eigen::Matrix3Xd points (3, size);
  for (double& value : points.reshaped ())
    value = random.uniform (-1, 1);
  points.colwise ().normalize ();
  return points.colwise () + center;
}

Eigen::Matrix3Xd
withCopies (const Eigen::Matrix3Xd& cloud, const Eigen::Vector3d& point, int copies)
{
  Eigen::Matrix3Xd result (3, cloud.cols () + copies);
  // Between the others, so that the order tells nothing.
  const Eigen::Index half = cloud.cols () / 2;
  result << cloud.leftCols (half), point.replicate (1, copies), cloud.rightCols (cloud.cols () - half);
  return result;
}

// Rings of points around an axis, the pole as often as a ring has points.
Eigen::Matrix3Xd
lathe (int rings, int around, const Eigen::Vector3d& pole)
{
  Eigen::Matrix3Xd points (3, (rings + 1) * around);
  for (Eigen::Index i = 0; i < points.cols (); ++i) {
    const double radius = static_cast<double> (i / around) / rings;
    const double angle = 2 * PI * static_cast<double> (i % around) / around;
    points.col (i) =
      pole + Eigen::Vector3d (radius * std::cos (angle), radius * std::sin (angle), radius * radius);
  }
  return points;
}

SampleSet
samplesOf (const Eigen::Matrix3Xd& cloud)
{
  SampleSet samples;
  EXPECT_EQ (makeSampleSet (cloud, {}, {}, DOUBLES, samples), Status::OK);
  return samples;
}

TEST (NoMeasurement, IsLeftOut)
{
  const Eigen::Vector3d moved (3, -2, 0.5);
  for (const Eigen::Vector3d& place : {Eigen::Vector3d (0, 0, 0), Eigen::Vector3d (0, -0.0, 0), moved})
    for (const int copies : {2, 3, 155, 20000}) {
      if (place == moved && copies < 16)
        continue;
      const SampleSet without = samplesOf (sphere (4000, place));
      const Eigen::Matrix3Xd cloud = withCopies (sphere (4000, place), place, copies);
      const SampleSet samples = samplesOf (cloud);
      ASSERT_EQ (samples.no_measurement, static_cast<std::size_t> (copies));
      EXPECT_EQ (samples.duplicates, 0U);
      EXPECT_EQ (samples.size (), 4000);
      EXPECT_TRUE (samples.points == without.points && samples.scale == without.scale &&
                   samples.origin == without.origin);
      for (Eigen::Index i = 0; i < cloud.cols (); ++i) {
        const std::int32_t sample = samples.sample_of[static_cast<std::size_t> (i)];
        ASSERT_EQ (sample < 0, cloud.col (i) == place);
        ASSERT_TRUE (sample < 0 ||
                     cloud.col (samples.input_index[static_cast<std::size_t> (sample)]) == cloud.col (i));
      }
    }
}

TEST (NoMeasurement, DoesNotDependOnTheOrder)
{
  const Eigen::Matrix3Xd cloud = withCopies (sphere (1000), Eigen::Vector3d::Zero (), 40);
  const SampleSet samples = samplesOf (cloud);
  const SampleSet reversed = samplesOf (cloud.rowwise ().reverse ());
  EXPECT_EQ (reversed.no_measurement, 40U);
  EXPECT_TRUE (samples.points == reversed.points);
}

TEST (NoMeasurement, OfFewPointsOrAMovedCloudIsFoundBesideSomeDuplicates)
{
  Eigen::Matrix3Xd cloud = withCopies (sphere (4000), Eigen::Vector3d::Zero (), 200);
  cloud.leftCols (100) = cloud.middleCols (100, 100).eval ();
  const SampleSet samples = samplesOf (cloud);
  EXPECT_EQ (samples.no_measurement, 200U);
  EXPECT_EQ (samples.duplicates, 100U);
}

TEST (NoMeasurement, IsLeftOutWithDustBesideIt)
{
  Eigen::Matrix3Xd cloud = withCopies (sphere (4000), Eigen::Vector3d::Zero (), 200);
  cloud.leftCols (5) *= 0.02;
  EXPECT_EQ (samplesOf (cloud).no_measurement, 200U);
}

// Nothing is lost of what is a point.
TEST (NoMeasurement, IsNotWhatMayBeAPoint)
{
  const Eigen::Vector3d zero = Eigen::Vector3d::Zero ();
  const auto keepsAll = [] (const Eigen::Matrix3Xd& cloud, const char* what) {
    const SampleSet samples = samplesOf (cloud);
    EXPECT_EQ (samples.no_measurement, 0U) << what;
    EXPECT_EQ (static_cast<std::size_t> (samples.size ()) + samples.duplicates,
               static_cast<std::size_t> (cloud.cols ()))
      << what;
  };
  keepsAll (withCopies (sphere (4000), zero, 1), "one point at zero");
  keepsAll (zero.replicate (1, 100), "nothing but zeros");
  keepsAll (withCopies (sphere (1), zero, 100), "zeros and one point");
  const Eigen::Matrix3Xd one = withCopies (sphere (500), zero, 1);
  keepsAll ((Eigen::Matrix3Xd (3, 1002) << one, one).finished (), "every point twice");
  keepsAll (withCopies ((Eigen::Matrix3Xd (3, 1000) << sphere (500), sphere (500)).finished (), zero, 8),
            "eight at zero, two elsewhere");
  for (const Eigen::Vector3d& pole : {zero, Eigen::Vector3d (1, 2, 3)})
    for (const int rings : {8, 20, 40})
      keepsAll (lathe (rings, 60, pole), "the pole of a lathe");
  Eigen::Matrix3Xd ends (3, 2 * 61 * 60);
  ends << lathe (60, 60, zero), lathe (60, 60, {0, 0, 5});
  keepsAll (ends, "two poles");
  keepsAll (withCopies (withCopies (sphere (4000), {5, 5, 5}, 30), {-5, 5, 5}, 30), "two places alike");
  Eigen::Matrix3Xd grid (3, 1000);
  for (int i = 0; i < 1000; ++i)
    grid.col (i) << i % 10, i / 10 % 10, i / 100;
  keepsAll (grid, "a grid");
  keepsAll (withCopies (grid, {3, 3, 3}, 50), "a place beside others");
}

TEST (StrayPoints, DoNotEnlargeTheBulk)
{
  for (const int size : {8, 100, 5000, 60000}) {
    const Eigen::Matrix3Xd cloud = sphere (size);
    const Eigen::AlignedBox3d box = bulkBox (cloud);
    EXPECT_TRUE (box.min () == cloud.rowwise ().minCoeff () && box.max () == cloud.rowwise ().maxCoeff ());
    for (const double far : {1e3, -1e9, 3.4e38, -1e308}) {
      const Eigen::AlignedBox3d bulk = bulkBox (withCopies (cloud, {far, 0, 0}, 1));
      EXPECT_LT (bulk.sizes ().maxCoeff (), 30.0) << size << " " << far;
      EXPECT_TRUE (bulk.contains (box)) << size << " " << far;
    }
  }
  EXPECT_TRUE (bulkBox (Eigen::Matrix3Xd (3, 0)).isEmpty ());
  EXPECT_TRUE (bulkBox (Eigen::Vector3d (0, std::numeric_limits<double>::quiet_NaN (), 0)).isEmpty ());
  EXPECT_EQ (bulkBox (Eigen::Vector3d (1, 2, 3).replicate (1, 50000)).sizes ().maxCoeff (), 0.0);
}

// Copies are one point: they are no bulk.
TEST (StrayPoints, AreNotTheBulkForTheirCopies)
{
  const Eigen::Matrix3Xd cloud = withCopies (sphere (2000, {4e5, 5e6, 100}), Eigen::Vector3d::Zero (), 30000);
  EXPECT_GT (bulkBox (cloud).min ().y (), 4.9e6);
}

TEST (StrayPoints, DoNotHideThatFloatsAreTooCoarse)
{
  const Eigen::Matrix3Xd map = sphere (4000, {5e5, 5.6e6, 40});
  for (const Eigen::Vector3d& place : {Eigen::Vector3d (0, 0, 0), Eigen::Vector3d (1, 1e9, 1)})
    for (const int copies : {0, 1, 3, 300}) {
      const Eigen::Matrix3Xd cloud = withCopies (map, place, copies).cast<float> ().cast<double> ();
      SampleSet samples;
      EXPECT_EQ (makeSampleSet (cloud, {}, {}, FLOATS, samples), Status::INPUT_TOO_COARSE) << copies;
    }
}

TEST (StrayPoints, AreNotTooCoarseThemselves)
{
  for (const double far : {1e9, -3.4e38}) {
    const Eigen::Matrix3Xd cloud = withCopies (sphere (4000), {0, 0, far}, 1).cast<float> ().cast<double> ();
    SampleSet samples;
    EXPECT_EQ (makeSampleSet (cloud, {}, {}, FLOATS, samples), Status::OK);
    EXPECT_EQ (samples.size (), 4001);
    EXPECT_TRUE (samples.origin.isZero ());
  }
}

TEST (StrayPoints, LeaveTheOriginAndTheOrderOfTheOthers)
{
  const Eigen::Matrix3Xd map = sphere (4000, {5e5, 5.6e6, 40});
  const SampleSet without = samplesOf (map);
  EXPECT_TRUE (without.origin.y () != 0.0);
  for (const Eigen::Vector3d& place : {Eigen::Vector3d (0, 0, 0), Eigen::Vector3d (1, 1e9, 1)}) {
    const SampleSet samples = samplesOf (withCopies (map, place, 1));
    EXPECT_LT ((samples.origin - without.origin).norm (), 50.0);
    // Neighbours in the order are near each other, as they are without the stray.
    const auto meanStep = [] (const SampleSet& set) {
      std::vector<double> steps;
      for (std::int32_t i = 1; i < set.size (); ++i)
        steps.push_back ((set.points.col (i) - set.points.col (i - 1)).norm () / set.scale);
      std::nth_element (steps.begin (), steps.begin () + 2000, steps.end ());
      return steps[2000];
    };
    EXPECT_LT (meanStep (samples), 2 * meanStep (without));
  }
}

// With one cell for all of them this would take minutes.
TEST (StrayPoints, DoNotSlowThinningDown)
{
  Eigen::Matrix3Xd cloud = sphere (100000);
  const std::vector<std::uint8_t> without = pcl::manifold::thinBySpacing (cloud, 1e-4);
  cloud.col (0) << 0, 0, -3.4e38;
  cloud.col (1) << 0, 1e-9, -3.4e38;
  const std::vector<std::uint8_t> kept = pcl::manifold::thinBySpacing (cloud, 1e-4);
  const auto count = [] (const std::vector<std::uint8_t>& flags) {
    return std::count (flags.begin (), flags.end (), 1);
  };
  EXPECT_NEAR (static_cast<double> (count (kept)), static_cast<double> (count (without)), 100.0);
  EXPECT_EQ (kept[0] + kept[1], 1);
}

} // namespace
