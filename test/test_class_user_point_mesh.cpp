// A point type of a user's own. The base class of CoconeShape names PCL's search trees, which PCL
// instantiates for its own types only.
#define PCL_NO_PRECOMPILE

#include "test_class_clouds.h"
#include "test_class_point_type.h"

#include <gtest/gtest.h>
#include <pcl/conversions.h>
#include <pcl/manifold/cocone_shape.h>

namespace {

using namespace class_clouds;

TEST (UserPointType, IsReconstructedWithItsFields)
{
  const auto cloud = cloudOf<SurveyPoint> (torusAndKnot ());
  (*cloud)[7].reflectance = 0.25f;
  pcl::CoconeShape<SurveyPoint> shape;
  shape.setInputCloud (cloud);
  pcl::PolygonMesh mesh;
  shape.reconstruct (mesh);
  EXPECT_EQ (shape.getStatus (), pcl::manifold::Status::OK);
  pcl::PointCloud<SurveyPoint> back;
  pcl::fromPCLPointCloud2 (mesh.cloud, back);
  ASSERT_EQ (back.size (), cloud->size ());
  EXPECT_EQ (back[7].reflectance, 0.25f);
}

} // namespace
