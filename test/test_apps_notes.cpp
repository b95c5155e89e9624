// What the apps tell of a cloud that is not what it seems: rays without measurement, and rows of points that
// look like curves.
#include "test_apps_run.h"

#include <gtest/gtest.h>
#include <json/reader.h>

#include <cmath>
#include <memory>
#include <sstream>

namespace {

using namespace apps_run;

constexpr double PI = 3.141592653589793;

// A sphere around the sensor, in a spiral, and rays without measurement between its points.
std::string
scan (int points, int zeros, const std::string& zero, double east, double north)
{
  std::ostringstream text;
  text.precision (12);
  for (int i = 0; i < points; ++i) {
    const double z = 1 - (2.0 * i + 1) / points;
    const double angle = PI * (3 - std::sqrt (5.0)) * i;
    const double r = std::sqrt (1 - z * z);
    text << east + 5 * r * std::cos (angle) << " " << north + 5 * r * std::sin (angle) << " " << 5 * z
         << "\n";
    if (i % 7 == 0 && i / 7 < zeros)
      text << zero << "\n";
  }
  return text.str ();
}

// Closed thin sections, each denser along itself than sections are apart.
std::string
sections (double apart)
{
  std::ostringstream text;
  for (int section = 0; section < 40; ++section)
    for (int i = 0; i < 100; ++i)
      text << 4 * std::cos (0.02 * PI * i) << " " << apart * section << " " << std::sin (0.02 * PI * i)
           << "\n";
  return text.str ();
}

class Notes : public testing::TestWithParam<const char*>
{
protected:
  TestFolder folder;

  Outcome runOn (const std::string& input, const std::string& options = "")
  {
    const std::string app = GetParam ();
    const std::string output = app.find ("dimension") == std::string::npos ? "out.ply" : "out.pcd";
    return run (folder, app,
                "'" + input + "' '" + folder / output + "' -threads 1 -report '" + folder / "report" + "'" +
                  options);
  }

  Json::Value report () const
  {
    Json::Value root;
    std::istringstream stream (folder.read ("report"));
    EXPECT_TRUE (Json::parseFromStream (Json::CharReaderBuilder (), stream, &root, nullptr));
    return root;
  }
};

TEST_P (Notes, TellsOfRaysWithoutMeasurement)
{
  const std::string said = "60 points at one place far from all others left out: no measurement";
  const Outcome near = runOn (folder.write ("near.xyz", scan (3000, 60, "0 0 0", 0, 0)));
  ASSERT_EQ (near.exit_status, 0) << near.error;
  EXPECT_NE (near.error.find (said), std::string::npos) << near.error;
  EXPECT_EQ (report ()["input"]["no_measurement"].asInt (), 60);
  EXPECT_EQ (report ()["input"]["duplicates"].asInt (), 0);
  EXPECT_EQ (report ()["input"]["samples"].asInt (), 3000);

  const Outcome map = runOn (folder.write ("map.xyz", scan (3000, 60, "0 0 0", 4e5, 5.6e6)));
  ASSERT_EQ (map.exit_status, 0) << map.error;
  EXPECT_NE (map.error.find (said), std::string::npos) << map.error;
  EXPECT_EQ (report ()["input"]["no_measurement"].asInt (), 60);
  EXPECT_EQ (report ()["input"]["dropped"].asInt (), 0);
  EXPECT_EQ (report ()["input"]["samples"].asInt (), 3000);
  EXPECT_NEAR (report ()["input"]["origin"][1].asDouble (), 5.6e6, 100);

  const Outcome clean = runOn (folder.write ("clean.xyz", scan (3000, 1, "0 0 0", 0, 0)));
  ASSERT_EQ (clean.exit_status, 0) << clean.error;
  EXPECT_EQ (clean.error.find ("measurement"), std::string::npos) << clean.error;
  EXPECT_EQ (report ()["input"]["no_measurement"].asInt (), 0);
}

INSTANTIATE_TEST_SUITE_P (Apps, Notes,
                          testing::Values (DIMENSION_DETECTION_APP, COCONE_SHAPE_APP,
                                           FIXED_POINT_RECONSTRUCTION_APP, GRAPH_RECONSTRUCTION_APP),
                          [] (const auto& tested) {
                            const std::string app = tested.param;
                            return app.substr (app.rfind ('/') + 1);
                          });

class Rows : public Notes
{};

TEST_P (Rows, TellsWhatHelpsWhereTheyLookLikeCurves)
{
  // At all scales rows are no curves.
  const std::string once = GetParam () == std::string (DIMENSION_DETECTION_APP) ? " -published" : "";
  const Outcome rows = runOn (folder.write ("rows.xyz", sections (1.5)), once);
  ASSERT_EQ (rows.exit_status, 0) << rows.error;
  EXPECT_NE (rows.error.find ("-thin 8"), std::string::npos) << rows.error;
  EXPECT_GT (report ()["result"]["contradicted"].asInt (), 2000);
  // Curves far apart are curves.
  const Outcome curves = runOn (folder.write ("curves.xyz", sections (20)), once);
  ASSERT_EQ (curves.exit_status, 0) << curves.error;
  EXPECT_EQ (curves.error.find ("-thin 8"), std::string::npos) << curves.error;
  EXPECT_LT (report ()["result"]["contradicted"].asInt (), 400);
}

INSTANTIATE_TEST_SUITE_P (Apps, Rows, testing::Values (DIMENSION_DETECTION_APP, COCONE_SHAPE_APP),
                          [] (const auto& tested) {
                            const std::string app = tested.param;
                            return app.substr (app.rfind ('/') + 1);
                          });

} // namespace
