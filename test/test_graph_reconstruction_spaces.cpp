// The public class: points of any dimension and of any type.
#include "test_class_point_type.h"
#include "test_graph_runs.h"

#include <gtest/gtest.h>
#include <pcl/conversions.h>
#include <pcl/point_representation.h>
#include <pcl/register_point_struct.h>

#include <cmath>

POINT_CLOUD_REGISTER_POINT_STRUCT (pcl::Histogram<4>, (float[4], histogram, histogram))

namespace {

using namespace graph_runs;

using Histogram = pcl::Histogram<4>;

/** All four numbers of a histogram. */
class AllFour : public pcl::PointRepresentation<Histogram>
{
public:
  AllFour () { nr_dimensions_ = 4; }

  void copyToFloatArray (const Histogram& point, float* out) const override
  {
    std::copy (point.histogram, point.histogram + 4, out);
  }
};

/** The flat torus in four dimensions. */
pcl::PointCloud<Histogram>::Ptr
flatTorus (std::size_t n)
{
  const auto cloud = std::make_shared<pcl::PointCloud<Histogram>> ();
  std::mt19937_64 engine (5);
  const auto angle = [&engine] {
    return 2.0f * static_cast<float> (M_PI) * static_cast<float> (engine () >> 40) / 16777216.0f;
  };
  for (std::size_t i = 0; i < n; ++i) {
    const float a = angle ();
    const float b = angle ();
    cloud->push_back (Histogram{{std::cos (a), std::sin (a), std::cos (b), std::sin (b)}});
  }
  return cloud;
}

TEST (GraphReconstructionSpace, MayHaveAnyDimension)
{
  const auto cloud = flatTorus (40000);
  (*cloud)[7].histogram[3] = NOT_A_NUMBER;
  (*cloud)[9] = (*cloud)[8];
  ReconstructionOf<Histogram> run;
  run.object.setInputCloud (cloud);
  run.object.setHops (6);
  run.object.setPointRepresentation (std::make_shared<AllFour> ());
  EXPECT_FALSE (run ());
  expectClosedOfGenus (run.object.getReport (), 1);
  EXPECT_EQ (run.object.getTiles ()[7], -1);
  EXPECT_EQ (run.object.getTiles ()[9], run.object.getTiles ()[8]);

  // Of any order, too.
  const std::vector<int> order = permutation (cloud->size ());
  const auto shuffled = std::make_shared<pcl::PointCloud<Histogram>> ();
  for (const int i : order)
    shuffled->push_back ((*cloud)[static_cast<std::size_t> (i)]);
  const std::multiset<pcl::Indices> expected = faces (run.polygons);
  // Which of the two equal points is in the mesh is up to their order.
  std::vector<int> number = order;
  std::replace (number.begin (), number.end (), 9, 8);
  run.object.setInputCloud (shuffled);
  EXPECT_FALSE (run ());
  EXPECT_EQ (faces (run.polygons, number), expected);
}

TEST (GraphReconstructionSpace, IsNotTheFirstThreeNumbersOfAHistogram)
{
  ReconstructionOf<Histogram> run;
  run.object.setInputCloud (flatTorus (2000));
  expectFailure (run, Status::PARAMETER_OUT_OF_RANGE); // no representation
  run.object.setPointRepresentation (std::make_shared<pcl::DefaultPointRepresentation<Histogram>> ());
  expectFailure (run, Status::PARAMETER_OUT_OF_RANGE);
  run.object.setPointRepresentation (std::make_shared<AllFour> ());
  EXPECT_FALSE (run ());
  EXPECT_NE (run.object.getPointRepresentation (), nullptr);
}

TEST (GraphReconstructionSpace, IsNotNeededWithAGraph)
{
  const std::vector<Eigen::Vector3f> torus = evenly ("torus", 3000);
  const auto cloud = std::make_shared<pcl::PointCloud<Histogram>> ();
  cloud->resize (torus.size ());
  ReconstructionOf<Histogram> run;
  run.object.setInputCloud (cloud);
  run.object.setNeighborhoodGraph (graphOf (torus));
  EXPECT_FALSE (run ());
  EXPECT_EQ (run.object.getStatus (), Status::OK);
}

TEST (GraphReconstructionSpace, OfThreeDimensionsIsThatOfThePoints)
{
  const auto cloud = cloudOf (evenly ("torus", 3000));
  Reconstruction by_default;
  by_default.object.setInputCloud (cloud);
  EXPECT_FALSE (by_default ());
  Reconstruction represented;
  represented.object.setInputCloud (cloud);
  represented.object.setPointRepresentation (
    std::make_shared<pcl::DefaultPointRepresentation<pcl::PointXYZ>> ());
  EXPECT_FALSE (represented ());
  EXPECT_EQ (faces (represented.polygons), faces (by_default.polygons));
}

// PCL's search trees are not compiled for it.
TEST (GraphReconstructionPoints, MayBeOfATypeOfTheUsersOwn)
{
  const auto cloud = cloudOf<SurveyPoint> (evenly ("torus", 3000));
  (*cloud)[7].reflectance = 0.25f;
  pcl::GraphReconstruction<SurveyPoint> object;
  object.setInputCloud (cloud);
  object.setHops (3);
  pcl::PolygonMesh mesh;
  pcl::PCLSurfaceBase<SurveyPoint>& base = object;
  base.reconstruct (mesh);
  EXPECT_EQ (object.getStatus (), Status::OK);
  EXPECT_FALSE (mesh.polygons.empty ());
  pcl::PointCloud<SurveyPoint> back;
  pcl::fromPCLPointCloud2 (mesh.cloud, back);
  ASSERT_EQ (back.size (), cloud->size ());
  EXPECT_EQ (back[7].reflectance, 0.25f);
}

template <typename PointT>
void
expectMesh ()
{
  ReconstructionOf<PointT> run;
  run.object.setInputCloud (cloudOf<PointT> (evenly ("torus", 3000)));
  EXPECT_FALSE (run ());
  EXPECT_TRUE ((std::is_base_of_v<pcl::MeshConstruction<PointT>, pcl::GraphReconstruction<PointT>>));
}

TEST (GraphReconstructionPoints, MayBeOfPclsTypes)
{
  expectMesh<pcl::PointXYZI> ();
  expectMesh<pcl::PointXYZRGB> ();
  expectMesh<pcl::PointNormal> ();
  expectMesh<pcl::PointXYZRGBNormal> ();
}

} // namespace
