// The public class: what it does with every kind of input, and that nothing but the points decides the
// result.
#include "test_class_contract.h"

#include <gtest/gtest.h>
#include <pcl/manifold/dimension_detection.h>

namespace {

using namespace class_contract;

// The published method, once; the scales have tests of their own.
template <typename PointT>
struct DetectionOf
{
  pcl::DimensionDetection<PointT> object;
  pcl::PointCloud<pcl::Label> labels;

  DetectionOf () { object.setScales (pcl::manifold::Scales::OFF); }

  bool operator() ()
  {
    object.compute (labels);
    return labels.empty () && object.getManifoldDimension ().empty () && object.getBoundary ().empty () &&
           object.getConfidence ().empty () && object.getHeights ().cols () == 0 &&
           object.getSamples ().empty () && object.getSampleDimensions () == nullptr &&
           object.getDelaunayComplex () == nullptr;
  }

  std::vector<std::uint32_t> values () const
  {
    std::vector<std::uint32_t> result;
    for (const pcl::Label& label : labels)
      result.push_back (label.label);
    return result;
  }
};

using Detection = DetectionOf<pcl::PointXYZ>;

Detection
detect (const std::vector<Eigen::Vector3f>& points, unsigned int threads = 1, int k = 0)
{
  Detection run;
  run.object.setInputCloud (cloudOf (points));
  run.object.setNumberOfThreads (threads);
  run.object.setThinningNeighbors (k);
  run ();
  EXPECT_EQ (run.object.getStatus (), Status::OK);
  return run;
}

TEST (DimensionDetection, SaysWhatIsWrongWithTheInput)
{
  checkInputs<Detection> ();
}

TEST (DimensionDetection, SaysWhatIsWrongWithTheIndices)
{
  checkIndices<Detection> ();
}

TEST (DimensionDetection, RefusesParametersOutOfRange)
{
  checkRho<Detection> ();
  checkThinning<Detection> ();
}

TEST (DimensionDetection, CanBeCancelledAtEveryStage)
{
  checkProgress<Detection> ();
  checkStatusDuringRun<Detection> ();
}

TEST (DimensionDetection, SurvivesDegenerateClouds)
{
  Detection run;
  checkDegenerateClouds (run);
}

TEST (DimensionDetection, FlatAndStraightCloudsAreSurfacesAndCurves)
{
  for (const std::uint32_t label : detect (grid (30, 1, 1)).values ())
    EXPECT_EQ (label, 1U);
  const Detection sheet = detect (floats (generate::blueNoise (generate::shapeByName ("square"), 0.1, 3)));
  const std::vector<std::uint8_t> dimensions = sheet.object.getManifoldDimension ();
  // At the corners of the square most samples nearby are of the rim: they look like those of a curve.
  EXPECT_LE (std::count (dimensions.begin (), dimensions.end (), 1), 12);
  EXPECT_EQ (std::count (dimensions.begin (), dimensions.end (), 3), 0);
}

TEST (DimensionDetection, LabelsEveryPointInItsPlace)
{
  std::vector<Eigen::Vector3f> points = torusAndKnot ();
  const std::vector<std::uint32_t> labels = detect (points).values ();
  ASSERT_EQ (labels.size (), points.size ());
  for (std::size_t i = 0; i < points.size (); ++i)
    EXPECT_EQ (labels[i], points[i].x () > 2.0f ? 1U : 2U);

  // Points that are not finite keep their place, and duplicates share their label.
  std::vector<Eigen::Vector3f> more = points;
  more.insert (more.begin (), Eigen::Vector3f (0.0f, NOT_A_NUMBER, 0.0f));
  more.insert (more.end (), points.begin (), points.begin () + 10);
  const Detection run = detect (more);
  const std::vector<std::uint32_t> of_more = run.values ();
  ASSERT_EQ (of_more.size (), more.size ());
  EXPECT_EQ (of_more[0], 0U);
  EXPECT_TRUE (run.object.getHeights ().col (0).array ().isNaN ().all ());
  EXPECT_EQ (std::vector<std::uint32_t> (of_more.begin () + 1, of_more.end () - 10), labels);
  EXPECT_EQ (std::vector<std::uint32_t> (of_more.end () - 10, of_more.end ()),
             std::vector<std::uint32_t> (labels.begin (), labels.begin () + 10));
  EXPECT_EQ (run.object.getSamples ().size (), points.size ());
}

TEST (DimensionDetection, TakesOrganizedClouds)
{
  const std::vector<Eigen::Vector3f> points = torusAndKnot ();
  const auto cloud = cloudOf (points);
  while (cloud->size () % 16 != 0)
    cloud->push_back (pcl::PointXYZ (NOT_A_NUMBER, NOT_A_NUMBER, NOT_A_NUMBER));
  cloud->width = 16;
  cloud->height = static_cast<std::uint32_t> (cloud->size () / 16);
  cloud->is_dense = false;
  Detection run;
  run.object.setInputCloud (cloud);
  EXPECT_FALSE (run ());
  std::vector<std::uint32_t> expected = detect (points).values ();
  expected.resize (cloud->size (), 0);
  EXPECT_EQ (run.values (), expected);
}

TEST (DimensionDetection, KeepsTheLayoutOfAnOrganizedCloud)
{
  const Cloud::Ptr cloud = organizedCloud ();
  (*cloud)[7].x = NOT_A_NUMBER;
  cloud->is_dense = false;
  const auto all = std::make_shared<pcl::Indices> (cloud->size ());
  std::iota (all->begin (), all->end (), 0);
  for (const bool with_indices : {false, true}) {
    Detection run;
    run.object.setInputCloud (cloud);
    if (with_indices)
      run.object.setIndices (all);
    EXPECT_FALSE (run ());
    EXPECT_EQ (run.labels.width, 40U);
    EXPECT_EQ (run.labels.height, 30U);
    EXPECT_TRUE (run.labels.is_dense); // every point has a label
    EXPECT_EQ (run.labels.header.frame_id, "camera");
    EXPECT_EQ (run.labels.header.seq, 5U);
    EXPECT_EQ (run.labels.sensor_origin_, cloud->sensor_origin_);
    EXPECT_EQ (run.labels.sensor_orientation_.coeffs (), cloud->sensor_orientation_.coeffs ());
    EXPECT_EQ (run.labels (7, 0).label, 0U);
    EXPECT_NE (run.labels (8, 0).label, 0U);
  }
}

TEST (DimensionDetection, LabelsOfSomePointsAreInALine)
{
  const Cloud::Ptr cloud = organizedCloud ();
  pcl::Indices fewer (cloud->size () - 1);
  std::iota (fewer.begin (), fewer.end (), 0);
  pcl::Indices reversed (cloud->size ());
  std::iota (reversed.rbegin (), reversed.rend (), 0);
  for (const pcl::Indices& indices : {fewer, reversed}) {
    Detection run;
    run.object.setInputCloud (cloud);
    run.object.setIndices (std::make_shared<pcl::Indices> (indices));
    EXPECT_FALSE (run ());
    EXPECT_EQ (run.labels.width, indices.size ());
    EXPECT_EQ (run.labels.height, 1U);
    EXPECT_EQ (run.labels.header.frame_id, "camera");
    EXPECT_EQ (run.labels.sensor_origin_, cloud->sensor_origin_);
  }
  // A cloud that contradicts itself is no grid.
  cloud->width = 7;
  Detection run;
  run.object.setInputCloud (cloud);
  EXPECT_FALSE (run ());
  EXPECT_EQ (run.labels.width, cloud->size ());
  EXPECT_EQ (run.labels.height, 1U);
}

TEST (DimensionDetection, WorksOnTheIndicesOnly)
{
  const std::vector<Eigen::Vector3f> torus = floats (generate::blueNoise (generate::torus (), 0.09, 1));
  std::vector<Eigen::Vector3f> points = torusAndKnot ();
  ASSERT_TRUE (std::equal (torus.begin (), torus.end (), points.begin ()));
  std::vector<int> order = permutation (torus.size ());
  Detection run;
  run.object.setInputCloud (cloudOf (points));
  run.object.setIndices (std::make_shared<pcl::Indices> (order.begin (), order.end ()));
  EXPECT_FALSE (run ());
  EXPECT_EQ (run.labels.size (), torus.size ());
  pcl::Indices samples = run.object.getSamples ();
  std::sort (samples.begin (), samples.end ());
  std::sort (order.begin (), order.end ());
  EXPECT_EQ (samples, pcl::Indices (order.begin (), order.end ()));
}

TEST (DimensionDetection, CopiesTheHeader)
{
  const auto cloud = cloudOf (torusAndKnot ());
  cloud->header.frame_id = "map";
  cloud->header.stamp = 1234567;
  Detection run;
  run.object.setInputCloud (cloud);
  run ();
  EXPECT_EQ (run.labels.header.frame_id, "map");
  EXPECT_EQ (run.labels.header.stamp, 1234567U);
}

TEST (DimensionDetection, DoesNotDependOnThreadsOrOrder)
{
  const std::vector<Eigen::Vector3f> points = torusAndKnot ();
  const std::vector<int> order = permutation (points.size ());
  std::vector<Eigen::Vector3f> shuffled;
  for (const int i : order)
    shuffled.push_back (points[static_cast<std::size_t> (i)]);
  for (const int k : {0, 6}) {
    const Detection one = detect (points, 1, k);
    const Detection two = detect (points, 2, k);
    const Detection other = detect (shuffled, 2, k);
    EXPECT_EQ (one.values (), two.values ());
    EXPECT_EQ (one.object.getHeights (), two.object.getHeights ());
    EXPECT_EQ (one.object.getConfidence (), two.object.getConfidence ());
    EXPECT_EQ (one.object.getSamples (), two.object.getSamples ());
    const Eigen::Matrix3Xd heights = one.object.getHeights ();
    const Eigen::Matrix3Xd of_shuffled = other.object.getHeights ();
    for (std::size_t i = 0; i < order.size (); ++i) {
      EXPECT_EQ (other.labels[i].label, one.labels[static_cast<std::size_t> (order[i])].label);
      EXPECT_EQ (of_shuffled.col (static_cast<Eigen::Index> (i)), heights.col (order[i]));
    }
  }
}

TEST (DimensionDetection, HeightsAreInTheUnitOfTheCloud)
{
  const Eigen::Matrix3Xd heights = detect (torusAndKnot ()).object.getHeights ();
  const Eigen::Matrix3Xd larger =
    detect (transformed (torusAndKnot (), 1024.0f, {0, 0, 0})).object.getHeights ();
  for (Eigen::Index i = 0; i < heights.cols (); ++i)
    for (int j = 0; j < 3; ++j)
      EXPECT_TRUE (std::isinf (heights (j, i)) ? std::isinf (larger (j, i))
                                               : std::abs (larger (j, i) / heights (j, i) - 1024.0) < 1e-6);
}

TEST (DimensionDetection, ThinnedPointsTakeTheLabelOfTheNearestSample)
{
  const std::vector<Eigen::Vector3f> points = torusAndKnot ();
  const Detection run = detect (points, 1, 5);
  const pcl::Indices samples = run.object.getSamples ();
  ASSERT_LT (samples.size (), points.size ());
  for (std::size_t i = 0; i < points.size (); ++i) {
    const auto distance = [&] (pcl::index_t sample) {
      return (points[static_cast<std::size_t> (sample)].cast<double> () - points[i].cast<double> ())
        .squaredNorm ();
    };
    const pcl::index_t nearest = *std::min_element (
      samples.begin (), samples.end (), [&] (auto a, auto b) { return distance (a) < distance (b); });
    EXPECT_EQ (run.labels[i].label, run.labels[static_cast<std::size_t> (nearest)].label);
  }
}

TEST (DimensionDetection, SpacingIsKept)
{
  Detection run;
  const std::vector<Eigen::Vector3f> points = torusAndKnot ();
  run.object.setInputCloud (cloudOf (points));
  run.object.setThinningDistance (0.2);
  EXPECT_FALSE (run ());
  const pcl::Indices samples = run.object.getSamples ();
  for (std::size_t i = 0; i < samples.size (); ++i)
    for (std::size_t j = i + 1; j < samples.size (); ++j)
      EXPECT_GE (
        (points[static_cast<std::size_t> (samples[i])] - points[static_cast<std::size_t> (samples[j])])
          .norm (),
        0.1999f);
}

TEST (DimensionDetection, SharesATriangulationOfTheSameCloudOnly)
{
  const Detection first = detect (torusAndKnot ());
  const auto complex = first.object.getDelaunayComplex ();
  ASSERT_NE (complex, nullptr);
  Detection again;
  again.object.setInputCloud (cloudOf (torusAndKnot ()));
  again.object.setDelaunayComplex (complex);
  EXPECT_FALSE (again ());
  EXPECT_EQ (again.object.getDelaunayComplex (), complex);
  EXPECT_EQ (again.values (), first.values ());

  again.object.setThinningNeighbors (4);
  EXPECT_FALSE (again ());
  EXPECT_NE (again.object.getDelaunayComplex (), complex);
  again.object.setThinningNeighbors (0);
  again.object.setInputCloud (cloudOf (torusAndKnot (2)));
  EXPECT_FALSE (again ());
  EXPECT_NE (again.object.getDelaunayComplex (), complex);
  EXPECT_EQ (again.values (), detect (torusAndKnot (2)).values ());
}

TEST (DimensionDetection, TellsStages)
{
  const Detection run = detect (torusAndKnot ());
  EXPECT_GE (run.object.getStages ().size (), 3U);
  for (const pcl::manifold::Stage& stage : run.object.getStages ()) {
    EXPECT_FALSE (stage.name.empty ());
    EXPECT_GE (stage.seconds, 0.0);
  }
}

} // namespace
