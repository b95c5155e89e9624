// The dimension at all scales: the ladder against its definition, and what the class promises with nothing
// set.
#include "scales/scale_ladder.h"
#include "scales/sensor_coordinates.h"
#include "test_class_contract.h"

#include <generate/curves.h>
#include <generate/scenes.h>

#include <gtest/gtest.h>
#include <pcl/manifold/dimension_detection.h>

#include <cmath>
#include <numeric>

namespace {

using namespace class_contract;

struct Detection
{
  pcl::DimensionDetection<pcl::PointXYZ> object;
  pcl::PointCloud<pcl::Label> labels;

  bool operator() ()
  {
    object.compute (labels);
    return labels.empty () && object.getManifoldDimension ().empty () && object.getScale ().empty () &&
           object.getPersistence ().empty () && object.getTangents ().cols () == 0 &&
           object.getCurveOfPoint ().empty () && object.getCurves ().empty () &&
           object.getSamples ().empty () && !object.getSensorOrigin ();
  }
};

TEST (Scales, SayWhatIsWrongWithTheInput)
{
  checkInputs<Detection> ();
  checkIndices<Detection> ();
  checkRho<Detection> ();
  checkThinning<Detection> ();
}

TEST (Scales, CanBeCancelledAtEveryStage)
{
  checkProgress<Detection> ();
  checkStatusDuringRun<Detection> ();
}

TEST (Scales, SurviveDegenerateClouds)
{
  Detection run;
  checkDegenerateClouds (run);
}

TEST (Scales, RefuseRangesAndOriginsThatAreNone)
{
  const double infinity = std::numeric_limits<double>::infinity ();
  for (const auto& [from, to] : std::vector<std::pair<double, double>>{
         {-1.0, 0.0}, {0.0, -1.0}, {2.0, 1.0}, {std::nan (""), 0.0}, {0.0, infinity}}) {
    Detection run;
    run.object.setInputCloud (cloudOf (torusAndKnot ()));
    run.object.setScaleRange (from, to);
    expectFailure (run, Status::PARAMETER_OUT_OF_RANGE);
    run.object.setScaleRange (0.0, 0.0);
    EXPECT_FALSE (run ());
  }
  for (const double wrong : {std::nan (""), infinity}) {
    Detection run;
    run.object.setInputCloud (cloudOf (torusAndKnot ()));
    run.object.setSensorOrigin ({0.0, wrong, 0.0});
    expectFailure (run, Status::PARAMETER_OUT_OF_RANGE);
  }
  Detection both;
  both.object.setInputCloud (cloudOf (torusAndKnot ()));
  both.object.setSensorOrigin ({0.0, 0.0, 0.0});
  both.object.setScaleRange (0.1, 1.0);
  expectFailure (both, Status::PARAMETER_OUT_OF_RANGE);
  // On a point, and far away, are places as any.
  for (const Eigen::Vector3d& place :
       {Eigen::Vector3d (torusAndKnot ().front ().cast<double> ()), Eigen::Vector3d (1e9, 0.0, 0.0)}) {
    Detection run;
    run.object.setInputCloud (cloudOf (torusAndKnot ()));
    run.object.setSensorOrigin (place);
    EXPECT_FALSE (run ());
    ASSERT_TRUE (run.object.getSensorOrigin ());
    EXPECT_LT ((*run.object.getSensorOrigin () - place).norm (), 1e-6 * (1.0 + place.norm ()));
    EXPECT_EQ (run.object.getDelaunayComplex (), nullptr);
  }
}

TEST (Scales, DoNotDependOnThreadsOrOrderOrUnit)
{
  const std::vector<Eigen::Vector3f> points = torusAndKnot ();
  const std::vector<int> order = permutation (points.size ());
  std::vector<Eigen::Vector3f> shuffled;
  for (const int i : order)
    shuffled.push_back (points[static_cast<std::size_t> (i)]);
  Detection one, two, other, larger;
  one.object.setInputCloud (cloudOf (points));
  one.object.setNumberOfThreads (1);
  two.object.setInputCloud (cloudOf (points));
  two.object.setNumberOfThreads (2);
  other.object.setInputCloud (cloudOf (shuffled));
  larger.object.setInputCloud (cloudOf (transformed (points, 1024.0f, {0, 0, 0})));
  for (Detection* run : {&one, &two, &other, &larger})
    EXPECT_FALSE ((*run) ());
  EXPECT_EQ (one.object.getManifoldDimension (), two.object.getManifoldDimension ());
  EXPECT_EQ (one.object.getScale (), two.object.getScale ());
  EXPECT_EQ (one.object.getPersistence (), two.object.getPersistence ());
  EXPECT_EQ (one.object.getTangents (), two.object.getTangents ());
  EXPECT_EQ (one.object.getCurveOfPoint (), two.object.getCurveOfPoint ());
  EXPECT_EQ (one.object.getManifoldDimension (), larger.object.getManifoldDimension ());
  const auto dimension = one.object.getManifoldDimension (),
             of_shuffled = other.object.getManifoldDimension ();
  const auto scale = one.object.getScale (), scale_of_shuffled = other.object.getScale (),
             scale_of_larger = larger.object.getScale ();
  for (std::size_t i = 0; i < order.size (); ++i) {
    const auto j = static_cast<std::size_t> (order[i]);
    ASSERT_EQ (of_shuffled[i], dimension[j]);
    ASSERT_EQ (scale_of_shuffled[i], scale[j]);
    ASSERT_EQ (scale_of_larger[i], 1024.0f * scale[i]);
  }
}

TEST (Scales, TellTheCurveAndItsDirection)
{
  const std::vector<Eigen::Vector3f> points = torusAndKnot ();
  Detection run;
  run.object.setInputCloud (cloudOf (points));
  EXPECT_FALSE (run ());
  const auto dimension = run.object.getManifoldDimension ();
  const auto curve = run.object.getCurveOfPoint ();
  const Eigen::Matrix3Xf tangents = run.object.getTangents ();
  std::size_t on_curve = 0;
  for (std::size_t i = 0; i < points.size (); ++i) {
    EXPECT_EQ (dimension[i], points[i].x () > 2.0f ? 1 : 2);
    EXPECT_EQ (curve[i], points[i].x () > 2.0f ? 0 : -1);
    EXPECT_NEAR (tangents.col (static_cast<Eigen::Index> (i)).norm (), points[i].x () > 2.0f ? 1.0 : 0.0,
                 1e-5);
    on_curve += points[i].x () > 2.0f ? 1 : 0;
  }
  ASSERT_EQ (run.object.getCurves ().size (), 1U);
  EXPECT_EQ (run.object.getCurves ().front ().points, on_curve);
}

TEST (Scales, MeasureAPole)
{
  // Two metres of a pole of a radius of 5 cm, a point a centimetre, leaning a little.
  std::vector<Eigen::Vector3f> points;
  for (int i = 0; i < 2000; ++i) {
    const double angle = 2.399963 * i, height = 0.001 * i;
    points.emplace_back (static_cast<float> (0.05 * std::cos (angle) + 0.1 * height),
                         static_cast<float> (0.05 * std::sin (angle)), static_cast<float> (height));
  }
  Detection run;
  run.object.setInputCloud (cloudOf (points));
  run.object.setScaleRange (0.1, 1.0);
  EXPECT_FALSE (run ());
  ASSERT_EQ (run.object.getCurves ().size (), 1U);
  const pcl::manifold::CurveMeasures curve = run.object.getCurves ().front ();
  EXPECT_EQ (curve.points, points.size ());
  EXPECT_NEAR (curve.height, 2.0, 0.05);
  EXPECT_NEAR (curve.length, 2.0, 0.05);
  EXPECT_NEAR (curve.verticality, 1.0 / std::sqrt (1.01), 0.01);
  EXPECT_NEAR (curve.mean_radius, 0.05, 0.02);
  for (const float scale : run.object.getScale ())
    EXPECT_GE (scale, 0.1f);

  // It is a surface from near.
  run.object.setScaleRange (0.0, 0.03);
  EXPECT_FALSE (run ());
  const auto near = run.object.getManifoldDimension ();
  EXPECT_GE (std::count (near.begin (), near.end (), 2), 1900);
}

TEST (Scales, FindTheSceneWhateverItsSampling)
{
  struct Case
  {
    double spacing, noise, share;
  };
  // The noise in shares of the sphere's radius.
  for (const Case& given : {Case{0.05, 0.0, 0.999}, Case{0.12, 0.0, 0.995}, Case{0.05, 0.01, 0.999}}) {
    generate::LabelledCloud cloud = generate::mixedScene (given.spacing, 1);
    generate::addNoise (cloud, given.noise, 2);
    Detection run;
    run.object.setInputCloud (cloudOf (floats (cloud)));
    EXPECT_FALSE (run ());
    const auto dimension = run.object.getManifoldDimension ();
    std::size_t right = 0;
    for (std::size_t i = 0; i < cloud.size (); ++i)
      right += dimension[i] == cloud.labels[i] ? 1 : 0;
    EXPECT_GE (static_cast<double> (right), given.share * static_cast<double> (cloud.size ()))
      << given.spacing << ", noise " << given.noise;
  }
}

Eigen::Matrix3Xd
randomPoints (Eigen::Index count)
{
  Eigen::Matrix3Xd points (3, count);
  std::uint32_t state = 1;
  for (double& coordinate : points.reshaped ()) {
    state = state * 1664525U + 1013904223U;
    coordinate = static_cast<double> (state >> 8) * 0x1p-24;
  }
  return points;
}

TEST (ScaleLadder, LevelsAreSpacedAndMeansOfWhatTheyStandFor)
{
  for (const Eigen::Index count : {0, 1, 2, 4, 5, 40, 1500}) {
    const Eigen::Matrix3Xd points = randomPoints (count);
    if (count == 0)
      continue;
    const std::vector<pcl::manifold::ScaleLevel> levels = pcl::manifold::makeLadder (points, {});
    ASSERT_GE (levels.size (), 1U);
    EXPECT_EQ (levels.front ().centers, points);
    std::vector<std::int32_t> stands (static_cast<std::size_t> (count));
    std::iota (stands.begin (), stands.end (), 0);
    for (std::size_t l = 1; l < levels.size (); ++l) {
      EXPECT_NEAR (levels[l].spacing, levels.front ().spacing * std::pow (2.0, 0.5 * static_cast<double> (l)),
                   1e-12);
      for (std::int32_t& sample : stands)
        sample = levels[l].sample_of[static_cast<std::size_t> (sample)];
      Eigen::Matrix3Xd sums = Eigen::Matrix3Xd::Zero (3, levels[l].centers.cols ());
      Eigen::VectorXd counts = Eigen::VectorXd::Zero (levels[l].centers.cols ());
      for (Eigen::Index i = 0; i < count; ++i) {
        sums.col (stands[static_cast<std::size_t> (i)]) += points.col (i);
        counts[stands[static_cast<std::size_t> (i)]] += 1.0;
      }
      for (Eigen::Index s = 0; s < counts.size (); ++s) {
        ASSERT_GT (counts[s], 0.0);
        EXPECT_LT ((sums.col (s) / counts[s] - levels[l].centers.col (s)).norm (), 1e-12);
      }
      EXPECT_LT (levels[l].centers.cols (), l == 1 ? count : levels[l - 1].centers.cols ());
    }
  }
}

TEST (ScaleLadder, EndsWhereAllPointsAreOne)
{
  EXPECT_EQ (pcl::manifold::makeLadder (Eigen::Matrix3Xd::Ones (3, 1), {}).size (), 1U);
}

TEST (SensorCoordinates, AreTheSameInEveryUnitAndTakeDirectionsBack)
{
  const Eigen::Matrix3Xd points = randomPoints (500) * 20.0;
  const Eigen::Vector3d origin (3.0, 4.0, 5.0);
  const pcl::manifold::SensorCoordinates sensor (points, origin);
  const Eigen::Matrix3Xd seen = sensor.toSensor (points);
  const pcl::manifold::SensorCoordinates in_mm (points * 1000.0, origin * 1000.0);
  EXPECT_LT ((in_mm.toSensor (points * 1000.0) - seen).cwiseAbs ().maxCoeff (), 1e-9);
  for (Eigen::Index i = 0; i < points.cols (); ++i) {
    // The derivative along a direction, by differences.
    const Eigen::Vector3d direction = (points.col ((i + 1) % points.cols ()) - points.col (i)).normalized ();
    Eigen::Matrix3Xd beside (3, 1);
    beside.col (0) = points.col (i) + 1e-6 * direction;
    const Eigen::Vector3d there = (sensor.toSensor (beside).col (0) - seen.col (i)).normalized ();
    EXPECT_GT (std::abs (sensor.toSpace (points.col (i), there).normalized ().dot (direction)), 0.9999);
  }
}

} // namespace
