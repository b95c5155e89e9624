// The apps of GraphReconstruction as a user runs them.
#include "test_apps_contract.h"

#include <pcl/io/ply_io.h>
#include <pcl/manifold/complex_io.h>

#include <json/json.h>

#include <cmath>
#include <set>
#include <sstream>

namespace {

using namespace apps_contract;

/** Points of a sphere, one a line, spread evenly along a spiral. */
std::string
spherePoints (int count, const std::string& end = "\n")
{
  std::ostringstream lines;
  for (int i = 0; i < count; ++i) {
    const double z = 1.0 - (2.0 * i + 1.0) / count;
    const double radius = std::sqrt (1.0 - z * z);
    const double angle = 2.399963229728653 * i;
    lines << radius * std::cos (angle) << ' ' << radius * std::sin (angle) << ' ' << z << end;
  }
  return lines.str ();
}

std::string
spherePcd ()
{
  constexpr int POINTS = 4000;
  return pcd (POINTS, spherePoints (POINTS));
}

const std::vector<const char*> WRONG = {"-k 0",     "-k -1",       "-k 2.5",       "-k five",
                                        "-k 5 -k",  "-thin 5",     "-hops 0",      "-hops two",
                                        "-a -1",    "-rule holes", "-faces rule",  "-maxlength 2",
                                        "-seed -1", "-seed",       "-polygons no", "-rule POINTS "};

INSTANTIATE_TEST_SUITE_P (
  Graph, Apps,
  testing::Values (App{"pcl_graph_reconstruction", GRAPH_RECONSTRUCTION_APP, "out.ply", spherePcd, WRONG},
                   App{"pcl_graph_reconstruction", GRAPH_RECONSTRUCTION_APP, "out.obj", spherePcd, WRONG},
                   App{"pcl_graph_reconstruction", GRAPH_RECONSTRUCTION_APP, "out.vtk", spherePcd, WRONG}),
  [] (const auto& tested) { return nameOf (tested.param); });

class GraphApp : public testing::Test
{
protected:
  TestFolder logs, folder;

  std::string quoted (const std::string& name) const { return "'" + folder / name + "'"; }

  /** Runs the app on a file in the folder, with a report. */
  Outcome reconstruct (const std::string& input, const std::string& options = {},
                       const std::string& output = "out.ply") const
  {
    return run (logs, GRAPH_RECONSTRUCTION_APP,
                quoted (input) + " " + quoted (output) + " -report " + quoted ("r.json") + " " + options);
  }

  Json::Value report () const
  {
    Json::Value json;
    std::istringstream (folder.read ("r.json")) >> json;
    return json;
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

TEST_F (GraphApp, ReportsTheMesh)
{
  folder.write ("sphere.pcd", spherePcd ());
  const Outcome outcome = reconstruct ("sphere.pcd", "-hops 4 -a 6 -seed 9 -threads 1 -maxlength 7");
  EXPECT_EQ (outcome.exit_status, 0) << outcome.error;
  const Json::Value json = report ();
  EXPECT_EQ (json["app"], "pcl_graph_reconstruction");
  EXPECT_EQ (json["input"]["points"], 4000);
  EXPECT_EQ (json["input"]["samples"], 4000);
  const Json::Value& parameters = json["parameters"];
  EXPECT_EQ (parameters["k"], 15);
  EXPECT_EQ (parameters["hops"], 4);
  EXPECT_EQ (parameters["a"], 6);
  EXPECT_EQ (parameters["rule"], "points");
  EXPECT_EQ (parameters["faces"], "rotation");
  EXPECT_EQ (parameters["maxlength"], 7);
  EXPECT_EQ (parameters["polygons"], false);
  EXPECT_EQ (parameters["seed"], 9);
  EXPECT_EQ (parameters["threads"], 1);
  const Json::Value& mesh = json["result"]["landmark_mesh"];
  const Json::Value& surface = mesh["surfaces"];
  EXPECT_EQ (mesh["edges_in_no_face"], 0);
  EXPECT_EQ (mesh["edges"], surface["edges"]);
  EXPECT_EQ (mesh["landmarks"], surface["vertices"]);
  EXPECT_EQ (surface["boundary_edges"], 0);
  EXPECT_EQ (surface["euler_characteristic"], 2);
  ASSERT_EQ (surface["components"].size (), 1U);
  EXPECT_EQ (surface["components"][0]["genus"], 0);
  EXPECT_EQ (json["result"]["surfaces"]["components"][0]["genus"], 0);
  EXPECT_EQ (json["result"]["polygons"].asUInt (), triangles ("out.ply"));
  EXPECT_EQ (json["result"]["polygons"].asInt (), 2 * mesh["landmarks"].asInt () - 4);
  ASSERT_EQ (json["stages"].size (), 8U);
  EXPECT_EQ (json["stages"][0]["name"], "points");
  EXPECT_EQ (json["stages"][7]["name"], "triangulation");
  EXPECT_TRUE (contains (outcome.out, "genus")) << outcome.out;
}

TEST_F (GraphApp, CountsWhatItLeavesOut)
{
  const std::string points = spherePoints (1000);
  folder.write ("cloud.pcd", pcd (2003, points + points + "nan 1 2\n3 inf 1\nnan nan nan\n"));
  const Outcome outcome = reconstruct ("cloud.pcd", "-hops 3");
  EXPECT_EQ (outcome.exit_status, 0) << outcome.error;
  const Json::Value input = report ()["input"];
  EXPECT_EQ (input["points"], 2003);
  EXPECT_EQ (input["dropped"], 3);
  EXPECT_EQ (input["duplicates"], 1000);
  EXPECT_EQ (input["samples"], 1000);
}

TEST_F (GraphApp, LeavesLargerFacesIfAsked)
{
  folder.write ("sphere.pcd", spherePcd ());
  // A threshold so large that some tiles of a triangle do not count as adjacent.
  for (const std::string output : {"out.vtk", "out.obj", "out.ply"}) {
    SCOPED_TRACE (output);
    EXPECT_EQ (reconstruct ("sphere.pcd", "-a 12 -hops 4 -polygons", output).exit_status, 0);
    const Json::Value result = report ()["result"];
    EXPECT_EQ (result["surfaces"], result["landmark_mesh"]["surfaces"]);
    EXPECT_EQ (result["polygons"], result["surfaces"]["faces"]);
    EXPECT_GT (result["surfaces"]["faces"], result["surfaces"]["triangles"]);
    if (output != "out.vtk")
      EXPECT_GT (triangles (output), result["polygons"].asUInt ()) << "cut while they are read";
  }
  pcl::PolygonMesh mesh;
  ASSERT_GE (pcl::io::loadPLYFile (folder / "out.ply", mesh), 0);
  std::set<std::size_t> sizes;
  for (const pcl::Vertices& polygon : mesh.polygons)
    sizes.insert (polygon.vertices.size ());
  EXPECT_GT (sizes.size (), 1U);
}

TEST_F (GraphApp, KeepsTheFieldsOfTheCloud)
{
  std::string header = pcd (1000, "");
  header.replace (header.find ("x y z"), 5, "x y z intensity");
  header.replace (header.find ("4 4 4"), 5, "4 4 4 4");
  header.replace (header.find ("F F F"), 5, "F F F F");
  header.replace (header.find ("1 1 1"), 5, "1 1 1 1");
  folder.write ("cloud.pcd", header + spherePoints (1000, " 0.25\n"));
  EXPECT_EQ (reconstruct ("cloud.pcd", "-hops 3").exit_status, 0);
  EXPECT_TRUE (contains (folder.read ("out.ply"), "property float intensity"));
}

TEST_F (GraphApp, SkipsLinesThatDoNotConform)
{
  const std::string points = spherePoints (1000);
  folder.write ("clean.xyz", points);
  ASSERT_EQ (reconstruct ("clean.xyz", "-hops 3").exit_status, 0);
  const std::string expected = folder.read ("out.ply");
  const std::size_t middle = points.find ('\n', points.size () / 2) + 1;
  const std::string dirty = points.substr (0, middle) +
                            "no point at all\n1 2\n1 2 3 4 5\n\n# a note\n1 2 x\n" + points.substr (middle);
  const auto first_bad = std::count (points.begin (), points.begin () + static_cast<int> (middle), '\n') + 1;
  for (const std::string name : {"dirty.xyz", "dirty.ply"}) {
    SCOPED_TRACE (name);
    folder.write (name, dirty);
    const Outcome outcome = reconstruct (name, "-hops 3");
    EXPECT_EQ (outcome.exit_status, 0) << outcome.error;
    EXPECT_TRUE (
      contains (outcome.error, "4 lines skipped that hold no 3 numbers: lines " + std::to_string (first_bad) +
                                 ", " + std::to_string (first_bad + 1) + ", " +
                                 std::to_string (first_bad + 2) + ", " + std::to_string (first_bad + 5)))
      << outcome.error;
    EXPECT_EQ (folder.read ("out.ply"), expected);
  }
}

TEST_F (GraphApp, RefusesAPlyWithoutHeaderThatHoldsNoPoint)
{
  folder.write ("words.ply", "one two three\nfour five six\n");
  const Outcome outcome = reconstruct ("words.ply");
  EXPECT_EQ (outcome.exit_status, 1);
  EXPECT_TRUE (contains (outcome.error, "words.ply: no line holds a point")) << outcome.error;
  EXPECT_EQ (folder.count (), 1);
}

TEST_F (GraphApp, SaysThatThereIsNoSurface)
{
  std::string line;
  for (int i = 0; i < 500; ++i)
    line += std::to_string (i) + " 0 0\n";
  folder.write ("line.xyz", line);
  const Outcome outcome = reconstruct ("line.xyz");
  EXPECT_EQ (outcome.exit_status, 1);
  EXPECT_TRUE (contains (outcome.error, "line.xyz: no face was found: its points lie on no surface, or "
                                        "tiles are too few or touch too little, see -hops, -a and -k\n"))
    << outcome.error;
  EXPECT_EQ (folder.count (), 1);
}

TEST_F (GraphApp, TakesEveryRule)
{
  folder.write ("sphere.pcd", spherePcd ());
  for (const char* options : {"-rule points", "-rule edges -a 20", "-rule path", "-faces rotation",
                              "-faces cycles", "-rule path -faces cycles"}) {
    SCOPED_TRACE (options);
    EXPECT_EQ (reconstruct ("sphere.pcd", options).exit_status, 0);
  }
}

} // namespace
