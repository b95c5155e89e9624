// The apps of FixedPointReconstruction as a user runs them.
#include "test_apps_contract.h"

#include <generate/closed_surfaces.h>
#include <generate/sampling.h>
#include <pcl/manifold/complex_io.h>

#include <json/json.h>

#include <iomanip>
#include <sstream>

namespace {

using namespace apps_contract;

constexpr double SPACING = 0.09;

/** Points of a torus, one a line. */
std::string
torusPoints (double spacing, const Eigen::Vector3d& offset = Eigen::Vector3d::Zero ())
{
  std::ostringstream lines;
  lines << std::setprecision (12);
  for (const Eigen::Vector3d& point : generate::blueNoise (generate::torus (), spacing, 1).points)
    lines << (point + offset).transpose () << '\n';
  return lines.str ();
}

std::string
torusPcd ()
{
  const std::string points = torusPoints (SPACING);
  return pcd (static_cast<std::size_t> (std::count (points.begin (), points.end (), '\n')), points);
}

const std::vector<const char*> WRONG = {"-ratio 0", "-ratio nan",        "-ratio",     "-votes 0",
                                        "-votes 4", "-rho 0.3",          "-votes 1.5", "-initial",
                                        "-thin -1", "-thin-distance -1", "-k 5"};
const std::vector<const char*> WRONG_LANDMARKS = {"-k 0",  "-k -1",       "-k 2.5",    "-hops 0",
                                                  "-a -1", "-rule holes", "-ratio 0.3"};

INSTANTIATE_TEST_SUITE_P (FixedPoint, Apps,
                          testing::Values (App{"pcl_fixed_point_reconstruction",
                                               FIXED_POINT_RECONSTRUCTION_APP, "out.ply", torusPcd, WRONG},
                                           App{"pcl_fixed_point_reconstruction",
                                               FIXED_POINT_RECONSTRUCTION_APP, "out.vtu", torusPcd, WRONG},
                                           App{"landmarks_to_mesh", LANDMARKS_TO_MESH_APP, "out.ply",
                                               torusPcd, WRONG_LANDMARKS}),
                          [] (const auto& tested) { return nameOf (tested.param); });

class FixedPointApp : public testing::Test
{
protected:
  TestFolder logs, folder;

  std::string quoted (const std::string& name) const { return "'" + folder / name + "'"; }

  /** Runs an app on a file in the folder, with a report. */
  Outcome runOn (const std::string& input, const std::string& options = {},
                 const std::string& output = "out.ply",
                 const std::string& app = FIXED_POINT_RECONSTRUCTION_APP) const
  {
    return run (logs, app,
                quoted (input) + " " + quoted (output) + " -report " + quoted ("r.json") + " " + options);
  }

  Json::Value report () const
  {
    Json::Value json;
    std::istringstream (folder.read ("r.json")) >> json;
    return json;
  }

  /** The report is about one closed torus. */
  void expectTorus () const
  {
    const Json::Value result = report ()["result"];
    ASSERT_EQ (result["surfaces"]["components"].size (), 1U);
    EXPECT_EQ (result["surfaces"]["components"][0]["genus"].asInt (), 1);
    EXPECT_TRUE (result["surfaces"]["components"][0]["closed"].asBool ());
    EXPECT_EQ (result["surfaces"]["non_manifold_vertices"].asUInt (), 0U);
    EXPECT_EQ (result["vertices"], report ()["input"]["samples"]);
  }

  std::size_t triangles (const std::string& file) const
  {
    pcl::PCLPointCloud2 cloud;
    pcl::SimplicialComplex complex;
    std::string error;
    EXPECT_TRUE (pcl::manifold::loadComplex (folder / file, cloud, complex, error)) << error;
    return complex.triangles.size ();
  }
};

TEST_F (FixedPointApp, ReportsWhatItFound)
{
  folder.write ("torus.pcd", torusPcd ());
  const Outcome outcome = runOn ("torus.pcd");
  EXPECT_EQ (outcome.exit_status, 0) << outcome.error;
  expectTorus ();
  const Json::Value json = report ();
  EXPECT_EQ (json["parameters"]["ratio"].asDouble (), 0.8);
  EXPECT_EQ (json["parameters"]["votes"].asInt (), 3);
  EXPECT_FALSE (json["parameters"].isMember ("initial"));
  EXPECT_GT (json["result"]["anchored"].asUInt (), json["result"]["medial"].asUInt ());
  EXPECT_TRUE (json["result"].isMember ("chained"));
  EXPECT_EQ (triangles ("out.ply"), json["result"]["surfaces"]["triangles"].asUInt ());
}

TEST_F (FixedPointApp, StartsFromAMesh)
{
  folder.write ("coarse.xyz", torusPoints (2.5 * SPACING));
  folder.write ("torus.pcd", torusPcd ());
  for (const char* initial : {"coarse.ply", "coarse.obj"}) {
    SCOPED_TRACE (initial);
    EXPECT_EQ (runOn ("coarse.xyz", {}, initial).exit_status, 0);
    const Outcome outcome = runOn ("torus.pcd", "-initial " + quoted (initial));
    EXPECT_EQ (outcome.exit_status, 0) << outcome.error;
    expectTorus ();
    EXPECT_GE (report ()["result"]["iterations"].asInt (), 1);
    EXPECT_EQ (report ()["parameters"]["initial"].asString (), folder / initial);
    EXPECT_FALSE (report ()["result"].isMember ("anchored"));
  }
}

// Clouds with map coordinates are shifted, and so are meshes that go with them; those that the apps wrote are
// shifted already.
TEST_F (FixedPointApp, StartsFromAMeshInMapCoordinates)
{
  const Eigen::Vector3d offset (229885, 5569975, 80);
  folder.write ("near.xyz", torusPoints (2.5 * SPACING));
  folder.write ("coarse.xyz", torusPoints (2.5 * SPACING, offset));
  folder.write ("torus.xyz", torusPoints (SPACING, offset));
  EXPECT_EQ (runOn ("near.xyz", {}, "near.obj").exit_status, 0);
  // The same mesh with the coordinates of the map.
  std::istringstream lines (folder.read ("near.obj"));
  std::ostringstream moved;
  moved << std::setprecision (16);
  for (std::string line; std::getline (lines, line);) {
    std::istringstream words (line);
    std::string kind;
    Eigen::Vector3d point;
    if (words >> kind >> point[0] >> point[1] >> point[2] && kind == "v")
      moved << "v " << (point + offset).transpose () << '\n';
    else
      moved << line << '\n';
  }
  folder.write ("map.obj", moved.str ());
  EXPECT_EQ (runOn ("coarse.xyz", {}, "shifted.ply").exit_status, 0);
  ASSERT_NE (report ()["input"]["origin"][1].asDouble (), 0.0);
  for (const char* initial : {"map.obj", "shifted.ply"}) {
    SCOPED_TRACE (initial);
    const Outcome outcome = runOn ("torus.xyz", "-initial " + quoted (initial));
    EXPECT_EQ (outcome.exit_status, 0) << outcome.error;
    expectTorus ();
  }
}

TEST_F (FixedPointApp, RefusesMeshesThatAreNone)
{
  folder.write ("torus.pcd", torusPcd ());
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  folder.write ("empty.obj", "");
  folder.write ("no_faces.obj", points);
  folder.write ("edges.obj", points + "l 1 2\nl 2 3\n");
  folder.write ("nan.obj", "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  folder.write ("no_such_point.obj", points + "f 1 2 4\n");
  folder.write ("words.obj", points + "f one two three\n");
  folder.write ("mesh.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  folder.write ("truncated.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n");
  // A triangle so small that it lies between two points of the cloud, near to one of them.
  folder.write ("nowhere.obj", "v 1.4 0 0\nv 1.4000001 0 0\nv 1.4 0.0000001 0\nf 1 2 3\n");
  const std::ptrdiff_t before = folder.count ();
  for (const char* initial : {"missing.ply", "empty.obj", "no_faces.obj", "edges.obj", "nan.obj",
                              "no_such_point.obj", "words.obj", "mesh.off", "truncated.ply", "nowhere.obj"}) {
    SCOPED_TRACE (initial);
    const Outcome outcome = runOn ("torus.pcd", "-quiet -initial " + quoted (initial));
    EXPECT_EQ (outcome.exit_status, 1);
    EXPECT_EQ (outcome.error.rfind ("error: ", 0), 0U) << outcome.error;
    EXPECT_TRUE (contains (outcome.error, initial)) << outcome.error;
    EXPECT_EQ (std::count (outcome.error.begin (), outcome.error.end (), '\n'), 1) << outcome.error;
    EXPECT_EQ (folder.count (), before);
  }
}

TEST_F (FixedPointApp, LandmarksBecomeAMeshOfAllPoints)
{
  folder.write ("torus.xyz", torusPoints (0.5 * SPACING));
  const Outcome outcome = runOn ("torus.xyz", {}, "out.ply", LANDMARKS_TO_MESH_APP);
  EXPECT_EQ (outcome.exit_status, 0) << outcome.error;
  expectTorus ();
  const Json::Value result = report ()["result"];
  const Json::Value& meshes = result["meshes"];
  ASSERT_GE (meshes.size (), 2U);
  EXPECT_EQ (meshes.size () - 1, result["iterations"].asUInt ());
  EXPECT_LT (meshes[0]["vertices"].asUInt (), report ()["input"]["samples"].asUInt () / 4);
  EXPECT_EQ (meshes[meshes.size () - 1]["triangles"], result["surfaces"]["triangles"]);
  EXPECT_EQ (meshes[meshes.size () - 1]["hausdorff_distance"].asDouble (), 0.0);
  for (Json::ArrayIndex i = 0; i + 1 < meshes.size (); ++i)
    EXPECT_GT (meshes[i]["hausdorff_distance"].asDouble (), 0.0);
  EXPECT_GT (meshes[0]["hausdorff_distance"].asDouble (), meshes[1]["hausdorff_distance"].asDouble ());
  EXPECT_LT (meshes[0]["hausdorff_distance"].asDouble (), 10.0 * result["mean_edge"].asDouble ());
  EXPECT_NEAR (result["mean_edge"].asDouble (), 0.6 * SPACING, 0.1 * SPACING);
  EXPECT_TRUE (contains (outcome.out, "iteration 1"));
}

} // namespace
