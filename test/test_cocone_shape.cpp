// The public class: what it does with every kind of input, and that nothing but the points decides the
// result.
#include "test_class_contract.h"

#include <gtest/gtest.h>
#include <pcl/manifold/cocone_shape.h>
#include <pcl/manifold/topology_report.h>

#include <set>

namespace {

using namespace class_contract;

struct Reconstruction
{
  pcl::CoconeShape<pcl::PointXYZ> object;
  pcl::SimplicialComplex shape;

  bool operator() ()
  {
    object.reconstruct (shape);
    return shape.empty () && object.getSampleDimensions () == nullptr &&
           object.getDelaunayComplex () == nullptr;
  }
};

/** Through the base class, as a mesh. */
struct MeshReconstruction
{
  pcl::CoconeShape<pcl::PointXYZ> object;
  pcl::PolygonMesh mesh;

  bool operator() ()
  {
    static_cast<pcl::MeshConstruction<pcl::PointXYZ>&> (object).reconstruct (mesh);
    return mesh.polygons.empty () && mesh.cloud.data.empty () && object.getSampleDimensions () == nullptr &&
           object.getDelaunayComplex () == nullptr;
  }
};

std::shared_ptr<Reconstruction>
reconstruct (const std::vector<Eigen::Vector3f>& points, unsigned int threads = 1, int k = 0)
{
  const auto run = std::make_shared<Reconstruction> ();
  run->object.setInputCloud (cloudOf (points));
  run->object.setNumberOfThreads (threads);
  run->object.setThinningNeighbors (k);
  (*run) ();
  EXPECT_EQ (run->object.getStatus (), Status::OK);
  return run;
}

/** The simplices as sorted sets of vertices, renumbered. */
template <typename Simplex>
std::set<Simplex>
sorted (std::vector<Simplex> simplices, const std::vector<int>& number)
{
  for (Simplex& simplex : simplices) {
    for (pcl::index_t& vertex : simplex)
      vertex = number[static_cast<std::size_t> (vertex)];
    std::sort (simplex.begin (), simplex.end ());
  }
  return {simplices.begin (), simplices.end ()};
}

std::vector<int>
identity (std::size_t n)
{
  std::vector<int> numbers (n);
  std::iota (numbers.begin (), numbers.end (), 0);
  return numbers;
}

TEST (CoconeShape, SaysWhatIsWrongWithTheInput)
{
  checkInputs<Reconstruction> ();
  checkInputs<MeshReconstruction> ();
}

TEST (CoconeShape, SaysWhatIsWrongWithTheIndices)
{
  checkIndices<Reconstruction> ();
  checkIndices<MeshReconstruction> ();
}

TEST (CoconeShape, RefusesParametersOutOfRange)
{
  checkRho<Reconstruction> ();
  checkThinning<Reconstruction> ();
}

TEST (CoconeShape, CanBeCancelledAtEveryStage)
{
  checkProgress<Reconstruction> ();
  checkProgress<MeshReconstruction> ();
  checkStatusDuringRun<MeshReconstruction> ();
}

TEST (CoconeShape, KeepsTheLayoutOfAnOrganizedCloud)
{
  checkLayoutOfMesh<MeshReconstruction> ();
}

TEST (CoconeShape, NamesASearchThatIsNotUsedOnce)
{
  checkNeedlessSearch<MeshReconstruction> ();
}

TEST (CoconeShape, SurvivesDegenerateClouds)
{
  for (const bool watertight : {false, true}) {
    MeshReconstruction mesh;
    mesh.object.setWatertight (watertight);
    EXPECT_EQ (mesh.object.getWatertight (), watertight);
    // A shape may be empty although all went well: isolated points are none of its simplices.
    for (const Named& named : degenerateClouds ()) {
      SCOPED_TRACE (named.name);
      mesh.object.setInputCloud (cloudOf (named.points));
      const bool empty = mesh ();
      EXPECT_TRUE (empty || mesh.object.getStatus () == Status::OK);
      EXPECT_NE (mesh.object.getStatus (), Status::INTERNAL_ERROR);
      for (const pcl::Vertices& polygon : mesh.mesh.polygons) {
        EXPECT_TRUE (polygon.vertices.size () == 2 || polygon.vertices.size () == 3);
        for (const pcl::index_t vertex : polygon.vertices) {
          ASSERT_GE (vertex, 0);
          ASSERT_LT (static_cast<std::size_t> (vertex), named.points.size ());
          EXPECT_TRUE (named.points[static_cast<std::size_t> (vertex)].allFinite ());
        }
      }
    }
  }
}

TEST (CoconeShape, ALineIsAPolyline)
{
  const auto run = reconstruct (grid (20, 1, 1));
  EXPECT_EQ (run->shape.edges.size (), 19U);
  EXPECT_TRUE (run->shape.triangles.empty ());
  for (const auto& edge : run->shape.edges)
    EXPECT_EQ (std::abs (edge[0] - edge[1]), 1);
}

TEST (CoconeShape, AFlatGridIsOneSheet)
{
  const auto run = reconstruct (grid (12, 9, 1));
  const pcl::TopologyReport report = pcl::manifold::analyze (run->shape);
  // The corners may come off: most samples near them are of the rim, as if of a curve.
  EXPECT_LE (run->shape.triangles.size (), 2U * 11 * 8);
  EXPECT_GE (run->shape.triangles.size (), 2U * 11 * 8 - 4);
  EXPECT_TRUE (report.surface.isManifold ());
  EXPECT_EQ (report.surface.euler_characteristic, 1);
  EXPECT_EQ (report.surface.boundary_loops, 1U);
}

TEST (CoconeShape, ABlockOfAGridIsASolid)
{
  const auto run = reconstruct (grid (8, 8, 8));
  const pcl::TopologyReport report = pcl::manifold::analyze (run->shape);
  EXPECT_FALSE (run->shape.tetrahedra.empty ());
  EXPECT_TRUE (report.solid.boundary.isClosed ());
}

TEST (CoconeShape, MixedSceneIsWhatItIs)
{
  const auto run = reconstruct (torusAndKnot ());
  const pcl::TopologyReport report = pcl::manifold::analyze (run->shape);
  ASSERT_EQ (report.surface.components.size (), 1U);
  EXPECT_TRUE (report.surface.isClosed ());
  EXPECT_EQ (report.surface.components[0].genus, 1);
  ASSERT_EQ (report.curve.components.size (), 1U);
  EXPECT_TRUE (report.curve.components[0].closed);
  EXPECT_EQ (report.vertices, torusAndKnot ().size ());
  EXPECT_FALSE (run->object.getCandidates ().empty ());
  EXPECT_TRUE (pcl::CoconeShape<pcl::PointXYZ> ().getCandidates ().empty ());
}

TEST (CoconeShape, SolidsAreGivenByTheirBoundary)
{
  const std::vector<Eigen::Vector3f> ball =
    floats (generate::blueNoise (generate::shapeByName ("ball"), 0.2, 4));
  const auto run = reconstruct (ball);
  MeshReconstruction mesh;
  mesh.object.setInputCloud (cloudOf (ball));
  EXPECT_FALSE (mesh ());
  EXPECT_EQ (mesh.mesh.polygons.size (), run->shape.edges.size () + run->shape.triangles.size () +
                                           pcl::manifold::boundaryTriangles (run->shape.tetrahedra).size ());
  EXPECT_FALSE (run->shape.tetrahedra.empty ());
}

TEST (CoconeShape, BothReconstructionsOfTheBaseClassGiveTheSamePolygons)
{
  MeshReconstruction mesh;
  const auto cloud = cloudOf (torusAndKnot ());
  cloud->header.frame_id = "map";
  cloud->header.stamp = 77;
  mesh.object.setInputCloud (cloud);
  EXPECT_FALSE (mesh ());
  EXPECT_EQ (mesh.mesh.header.frame_id, "map");
  EXPECT_EQ (mesh.mesh.header.stamp, 77U);
  EXPECT_EQ (static_cast<std::size_t> (mesh.mesh.cloud.width) * mesh.mesh.cloud.height, cloud->size ());

  pcl::CoconeShape<pcl::PointXYZ> object;
  object.setInputCloud (cloud);
  std::vector<pcl::Vertices> polygons (5);
  static_cast<pcl::MeshConstruction<pcl::PointXYZ>&> (object).reconstruct (polygons);
  ASSERT_EQ (polygons.size (), mesh.mesh.polygons.size ());
  for (std::size_t i = 0; i < polygons.size (); ++i)
    EXPECT_EQ (polygons[i].vertices, mesh.mesh.polygons[i].vertices);
  object.setRho (7.0);
  static_cast<pcl::MeshConstruction<pcl::PointXYZ>&> (object).reconstruct (polygons);
  EXPECT_TRUE (polygons.empty ());
}

TEST (CoconeShape, IndicesAreThoseOfTheWholeCloud)
{
  const std::vector<Eigen::Vector3f> torus = floats (generate::blueNoise (generate::torus (), 0.09, 1));
  std::vector<Eigen::Vector3f> points (300, Eigen::Vector3f (NOT_A_NUMBER, 0.0f, 0.0f));
  points.insert (points.end (), torus.begin (), torus.end ());
  const auto indices = std::make_shared<pcl::Indices> ();
  for (std::size_t i = 300; i < points.size (); ++i)
    indices->push_back (static_cast<pcl::index_t> (i));
  Reconstruction run;
  run.object.setInputCloud (cloudOf (points));
  run.object.setIndices (indices);
  EXPECT_FALSE (run ());
  std::vector<int> back (points.size (), -1);
  for (std::size_t i = 0; i < torus.size (); ++i)
    back[i + 300] = static_cast<int> (i);
  EXPECT_EQ (sorted (run.shape.triangles, back),
             sorted (reconstruct (torus)->shape.triangles, identity (torus.size ())));
}

TEST (CoconeShape, DoesNotDependOnThreadsOrOrder)
{
  const std::vector<Eigen::Vector3f> points = torusAndKnot ();
  const std::vector<int> order = permutation (points.size ());
  std::vector<Eigen::Vector3f> shuffled;
  for (const int i : order)
    shuffled.push_back (points[static_cast<std::size_t> (i)]);
  for (const int k : {0, 4}) {
    const auto one = reconstruct (points, 1, k);
    const auto two = reconstruct (points, 2, k);
    const auto other = reconstruct (shuffled, 2, k);
    EXPECT_EQ (one->shape.edges, two->shape.edges);
    EXPECT_EQ (one->shape.triangles, two->shape.triangles);
    EXPECT_EQ (one->shape.tetrahedra, two->shape.tetrahedra);
    // Simplex by simplex in the same order, and with the same directions.
    ASSERT_EQ (one->shape.triangles.size (), other->shape.triangles.size ());
    for (std::size_t i = 0; i < one->shape.triangles.size (); ++i)
      for (std::size_t j = 0; j < 3; ++j)
        EXPECT_EQ (order[static_cast<std::size_t> (other->shape.triangles[i][j])],
                   one->shape.triangles[i][j]);
    EXPECT_EQ (sorted (other->shape.edges, order), sorted (one->shape.edges, identity (points.size ())));
  }
}

TEST (CoconeShape, SharesDimensionsOfTheSameCloudOnly)
{
  pcl::DimensionDetection<pcl::PointXYZ> detection;
  detection.setInputCloud (cloudOf (torusAndKnot ()));
  detection.setScales (pcl::manifold::Scales::OFF);
  pcl::PointCloud<pcl::Label> labels;
  detection.compute (labels);

  Reconstruction run;
  run.object.setInputCloud (cloudOf (torusAndKnot ()));
  run.object.setSampleDimensions (detection.getSampleDimensions ());
  EXPECT_FALSE (run ());
  EXPECT_EQ (run.object.getSampleDimensions (), detection.getSampleDimensions ());
  EXPECT_EQ (run.shape.triangles, reconstruct (torusAndKnot ())->shape.triangles);

  Reconstruction with_complex;
  with_complex.object.setInputCloud (cloudOf (torusAndKnot ()));
  with_complex.object.setDelaunayComplex (detection.getDelaunayComplex ());
  EXPECT_FALSE (with_complex ());
  EXPECT_EQ (with_complex.object.getDelaunayComplex (), detection.getDelaunayComplex ());
  EXPECT_EQ (with_complex.shape.triangles, run.shape.triangles);

  run.object.setInputCloud (cloudOf (torusAndKnot (2)));
  EXPECT_FALSE (run ());
  EXPECT_NE (run.object.getSampleDimensions (), detection.getSampleDimensions ());
  EXPECT_EQ (run.shape.triangles, reconstruct (torusAndKnot (2))->shape.triangles);
}

TEST (CoconeShape, OneObjectServesSeveralClouds)
{
  Reconstruction run;
  for (const std::uint64_t seed : {1, 2, 1}) {
    run.object.setInputCloud (cloudOf (torusAndKnot (seed)));
    EXPECT_FALSE (run ());
    EXPECT_EQ (run.shape.triangles, reconstruct (torusAndKnot (seed))->shape.triangles);
  }
}

} // namespace
