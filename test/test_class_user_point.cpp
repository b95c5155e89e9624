// A point type of a user's own. DimensionDetection takes it as it is.
#include "test_class_clouds.h"
#include "test_class_point_type.h"

#include <gtest/gtest.h>
#include <pcl/manifold/dimension_detection.h>

namespace {

using namespace class_clouds;

TEST (UserPointType, HasItsDimensionDetected)
{
  pcl::DimensionDetection<SurveyPoint> detection;
  detection.setInputCloud (cloudOf<SurveyPoint> (torusAndKnot ()));
  pcl::PointCloud<pcl::Label> labels;
  detection.compute (labels);
  EXPECT_EQ (detection.getStatus (), pcl::manifold::Status::OK);
  EXPECT_EQ (labels.size (), torusAndKnot ().size ());
}

} // namespace
