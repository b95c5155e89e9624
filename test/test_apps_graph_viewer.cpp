// The window of the viewer, drawn without a display, as a user would script it.
#include "test_apps_png.h"
#include "test_apps_run.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

namespace {

using namespace apps_run;

class Viewer : public testing::Test
{
protected:
  TestFolder logs, folder;

  void SetUp () override
  {
    std::ostringstream points;
    constexpr int POINTS = 3000;
    for (int i = 0; i < POINTS; ++i) {
      const double z = 1.0 - (2.0 * i + 1.0) / POINTS;
      const double radius = std::sqrt (1.0 - z * z);
      points << radius * std::cos (2.4 * i) << ' ' << radius * std::sin (2.4 * i) << ' ' << z << '\n';
    }
    folder.write ("sphere.xyz", points.str ());
  }

  Outcome view (const std::string& input, const std::string& options, const std::string& before = {}) const
  {
    return run (logs, GRAPH_RECONSTRUCTION_VIEWER_APP, "'" + folder / input + "' " + options,
                "cd '" + folder / "" + "' && " + before);
  }
};

TEST_F (Viewer, ShowsEveryStage)
{
  std::set<std::string> pictures;
  for (const char* keys : {"", "Right", "Right Right", "Right Right Right", "Right Right Right Up a K"}) {
    const Outcome outcome = view ("sphere.xyz", std::string ("-keys '") + keys + "' -screenshot shot.png");
    EXPECT_EQ (outcome.exit_status, 0) << outcome.error;
    expectPng (folder.read ("shot.png"), 1200, 900);
    pictures.insert (folder.read ("shot.png"));
  }
  EXPECT_EQ (pictures.size (), 5U);
  EXPECT_EQ (folder.count (), 2);
}

TEST_F (Viewer, SavesTheMeshAndThePicture)
{
  const Outcome outcome =
    view ("sphere.xyz", "-hops 3 -mesh mesh.obj -picture all.png -keys 'F2 F3 r' -screenshot shot.png");
  EXPECT_EQ (outcome.exit_status, 0) << outcome.error;
  EXPECT_TRUE (contains (folder.read ("mesh.obj"), "\nf "));
  expectPng (folder.read ("all.png"), 1600, 1200);
  EXPECT_EQ (folder.count (), 4);
}

TEST_F (Viewer, SaysWhatCannotBeSaved)
{
  for (const char* options : {"-mesh nowhere/mesh.ply -keys F2", "-picture nowhere/all.png -keys F3",
                              "-screenshot nowhere/shot.png"}) {
    SCOPED_TRACE (options);
    const Outcome outcome = view ("sphere.xyz", std::string ("-screenshot shot.png ") + options);
    EXPECT_NE (outcome.exit_status, 0);
    EXPECT_EQ (outcome.error.rfind ("error: ", 0), 0U) << outcome.error;
    EXPECT_EQ (folder.count (), 1);
  }
}

TEST_F (Viewer, RefusesWhatItCannotShow)
{
  folder.write ("nan.xyz", "nan nan nan\nnan 1 2\n");
  folder.write ("two.xyz", "0 0 0\n1 0 0\n");
  for (const char* input : {"missing.pcd", "nan.xyz", "two.xyz"}) {
    const Outcome outcome = view (input, "-screenshot shot.png");
    EXPECT_EQ (outcome.exit_status, 1);
    EXPECT_EQ (outcome.error.rfind ("error: ", 0), 0U) << outcome.error;
    EXPECT_TRUE (contains (outcome.error, input)) << outcome.error;
    EXPECT_EQ (std::count (outcome.error.begin (), outcome.error.end (), '\n'), 1) << outcome.error;
  }
  EXPECT_EQ (folder.count (), 3);
}

TEST_F (Viewer, RefusesWrongUsage)
{
  for (const char* options :
       {"-hops 0", "-keys F12 -screenshot a.png", "-picture a.png -screenshot a.png", "-mesh mesh.stl",
        "-picture all.jpg", "-screenshot shot.gif", "-rule none", "-no-such-option", "second.xyz"})
    EXPECT_EQ (view ("sphere.xyz", options).exit_status, 2) << options;
  EXPECT_EQ (folder.count (), 1);
}

TEST_F (Viewer, OpensNoWindowThatNobodySees)
{
  for (const char* before : {"unset DISPLAY; ", "DISPLAY= ", "DISPLAY=nowhere:0 ", "DISPLAY=:987 "}) {
    const Outcome outcome = view ("sphere.xyz", "", before);
    EXPECT_EQ (outcome.exit_status, 1);
    EXPECT_TRUE (contains (outcome.error, "sphere.xyz: a window needs a display with OpenGL: set DISPLAY, or "
                                          "use -screenshot\n"))
      << outcome.error;
    EXPECT_EQ (std::count (outcome.error.begin (), outcome.error.end (), '\n'), 1) << outcome.error;
  }
}

TEST_F (Viewer, ListsItsKeys)
{
  const Outcome outcome = run (logs, GRAPH_RECONSTRUCTION_VIEWER_APP, "-h");
  EXPECT_EQ (outcome.exit_status, 0);
  EXPECT_TRUE (contains (outcome.out, "Left, Right   cloud, tiles, adjacencies, faces")) << outcome.out;
}

} // namespace
