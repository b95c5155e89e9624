// A point type of a user's own. PCL's base class of mesh constructions names search trees, which PCL
// instantiates for its own types only: the classes here do without.
#include "test_class_clouds.h"
#include "test_class_point_type.h"

#include <gtest/gtest.h>
#include <pcl/conversions.h>
#include <pcl/manifold/cocone_shape.h>
#include <pcl/manifold/fixed_point_reconstruction.h>

namespace {

using namespace class_clouds;

template <typename Class>
void
expectFieldsKept ()
{
  const auto cloud = cloudOf<SurveyPoint> (torusAndKnot ());
  (*cloud)[7].reflectance = 0.25f;
  Class reconstruction;
  reconstruction.setInputCloud (cloud);
  pcl::PolygonMesh mesh;
  reconstruction.reconstruct (mesh);
  EXPECT_EQ (reconstruction.getStatus (), pcl::manifold::Status::OK);
  EXPECT_FALSE (mesh.polygons.empty ());
  pcl::PointCloud<SurveyPoint> back;
  pcl::fromPCLPointCloud2 (mesh.cloud, back);
  ASSERT_EQ (back.size (), cloud->size ());
  EXPECT_EQ (back[7].reflectance, 0.25f);
}

TEST (UserPointType, IsReconstructedWithItsFields)
{
  expectFieldsKept<pcl::CoconeShape<SurveyPoint>> ();
  expectFieldsKept<pcl::FixedPointReconstruction<SurveyPoint>> ();
}

} // namespace
