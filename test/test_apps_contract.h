#pragma once

#include "test_apps_run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

/** What every app keeps to that makes a file of a cloud, as a user runs it on input that is wrong: an exit
 * status, one line that says what and where, and no file left behind. Each test file that includes this says
 * which apps. */
namespace apps_contract {

using namespace apps_run;

struct App
{
  const char* name;
  const char* file;
  const char* output;           ///< a name that it can write to
  std::string (*good_cloud) (); ///< a PCD file in text that it makes something of
  std::vector<const char*> wrong_options;
};

inline std::string
nameOf (const App& app)
{
  std::string name = std::string (app.name) + "_" + app.output;
  std::replace (name.begin (), name.end (), '.', '_');
  return name;
}

class Apps : public testing::TestWithParam<App>
{
protected:
  TestFolder logs, folder;

  std::string quoted (const std::string& name) const { return "'" + folder / name + "'"; }

  Outcome runOn (const std::string& arguments, const std::string& before = {}) const
  {
    return run (logs, GetParam ().file, arguments, before);
  }

  static void expectOneLine (const Outcome& outcome, int exit_status)
  {
    EXPECT_EQ (outcome.exit_status, exit_status);
    EXPECT_EQ (outcome.error.rfind ("error: ", 0), 0U) << outcome.error;
    EXPECT_EQ (std::count (outcome.error.begin (), outcome.error.end (), '\n'), 1) << outcome.error;
    ASSERT_FALSE (outcome.error.empty ());
    EXPECT_EQ (outcome.error.back (), '\n');
  }

  /** The app fails on an input file and names it; the folder holds what it held before. */
  void expectRefused (const std::string& input)
  {
    SCOPED_TRACE (input);
    const std::ptrdiff_t before = folder.count ();
    const Outcome outcome = runOn (quoted (input) + " " + quoted (GetParam ().output) + " -report " +
                                   quoted ("r.json") + " -quiet");
    expectOneLine (outcome, 1);
    EXPECT_TRUE (contains (outcome.error, input)) << outcome.error;
    EXPECT_EQ (folder.count (), before) << "a file was left behind";
  }
};

TEST_P (Apps, RefuseFilesThatHoldNoCloud)
{
  expectRefused ("missing.pcd");
  folder.write ("empty.pcd", "");
  expectRefused ("empty.pcd");
  folder.write ("header_only.pcd", pcd (100, "").substr (0, 60));
  expectRefused ("header_only.pcd");
  folder.write ("truncated.pcd", GetParam ().good_cloud ().substr (0, 3000));
  expectRefused ("truncated.pcd");
  folder.write ("words.pcd", pcd (3, "1 2 3\n1 two 3\n4 5 6\n"));
  expectRefused ("words.pcd");
  folder.write ("noise.pcd", std::string (5000, '\xa7'));
  expectRefused ("noise.pcd");
  folder.write ("huge.pcd", pcd (99999999999ULL, "1 2 3\n"));
  expectRefused ("huge.pcd");
  folder.write ("cloud.docx", GetParam ().good_cloud ());
  expectRefused ("cloud.docx");
  folder.write ("truncated.ply",
                "ply\nformat binary_little_endian 1.0\nelement vertex 1000\nproperty float x\n"
                "property float y\nproperty float z\nend_header\nabc");
  expectRefused ("truncated.ply");
  folder.write ("words.xyz", "one two three\nfour five six\n");
  expectRefused ("words.xyz");
  std::filesystem::create_directory (folder / "folder.pcd");
  expectRefused ("folder.pcd");
}

TEST_P (Apps, DoNotWriteTwoFilesToOnePlace)
{
  folder.write ("cloud.pcd", GetParam ().good_cloud ());
  const std::string files = quoted ("cloud.pcd") + " " + quoted (GetParam ().output);
  for (const std::string& options :
       {"-report " + quoted (GetParam ().output), "-report " + quoted ("./cloud.pcd"),
        "-picture " + quoted ("p.png") + " -report " + quoted ("p.png")}) {
    SCOPED_TRACE (options);
    const Outcome outcome = runOn (files + " " + options);
    expectOneLine (outcome, 2);
    EXPECT_TRUE (contains (outcome.error, "names the same file as")) << outcome.error;
    EXPECT_EQ (folder.count (), 1);
  }
  EXPECT_EQ (folder.read ("cloud.pcd"), GetParam ().good_cloud ());
}

TEST_P (Apps, RefuseCloudsOfNoPoint)
{
  folder.write ("none.pcd", pcd (0, ""));
  expectRefused ("none.pcd");
  folder.write ("nan.pcd", pcd (3, "nan nan nan\nnan 1 2\n1 nan 2\n"));
  expectRefused ("nan.pcd");
}

TEST_P (Apps, SayWhyFewPointsAreNotEnough)
{
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
  for (std::size_t n = 1; n <= 4; ++n) {
    const std::string name = "points_" + std::to_string (n) + ".pcd";
    folder.write (name, pcd (n, points.substr (0, 6 * n)));
    const Outcome outcome = runOn (quoted (name) + " " + quoted (GetParam ().output) + " -quiet");
    if (outcome.exit_status == 0) {
      EXPECT_EQ (outcome.error, "");
      EXPECT_TRUE (std::filesystem::remove (folder / GetParam ().output)) << name;
    } else {
      expectOneLine (outcome, 1);
      EXPECT_FALSE (std::filesystem::exists (folder / GetParam ().output)) << name;
    }
  }
}

TEST_P (Apps, RefuseCoarseCoordinates)
{
  std::string data;
  for (int i = 0; i < 1000; ++i)
    data += "16777216 " + std::to_string (16777216 + 2 * (i % 40)) + " " + std::to_string (i / 40 * 2) + "\n";
  folder.write ("coarse.pcd", pcd (1000, data));
  expectRefused ("coarse.pcd");
}

TEST_P (Apps, RefuseOutputThatCannotBeWritten)
{
  folder.write ("good.pcd", GetParam ().good_cloud ());
  const std::string extension = std::filesystem::path (GetParam ().output).extension ().string ();
  std::filesystem::create_directory (folder / "taken" + extension);
  std::filesystem::create_symlink ("/dev/full", folder / "full" + extension);
  const std::ptrdiff_t before = folder.count ();
  for (const std::string& output : {"nowhere/out" + extension, "taken" + extension, "full" + extension}) {
    SCOPED_TRACE (output);
    expectOneLine (runOn (quoted ("good.pcd") + " " + quoted (output)), 1);
    EXPECT_EQ (folder.count (), before);
  }
  for (const char* output : {"out.unknown", "out"}) {
    SCOPED_TRACE (output);
    const Outcome outcome = runOn (quoted ("good.pcd") + " " + quoted (output));
    EXPECT_TRUE (contains (outcome.error, output)) << outcome.error;
    expectOneLine (outcome, outcome.exit_status == 2 ? 2 : 1);
    EXPECT_EQ (folder.count (), before);
  }
  const Outcome report =
    runOn (quoted ("good.pcd") + " " + quoted (GetParam ().output) + " -report " + quoted ("nowhere/r.json"));
  expectOneLine (report, 1);
  EXPECT_EQ (folder.count (), before);
}

TEST_P (Apps, LeaveNothingOnAFullDisk)
{
  folder.write ("good.pcd", GetParam ().good_cloud ());
  // A limit on the size of files fails the writing as a full disk does: part of the file is there already.
  const Outcome outcome = runOn (quoted ("good.pcd") + " " + quoted (GetParam ().output) + " -quiet",
                                 "trap '' XFSZ; ulimit -f 1; ");
  expectOneLine (outcome, 1);
  EXPECT_EQ (folder.count (), 1);
}

TEST_P (Apps, KeepTheFormerOutputWhenTheyFail)
{
  folder.write ("bad.pcd", "rubbish");
  folder.write (GetParam ().output, "of an earlier run");
  expectOneLine (runOn (quoted ("bad.pcd") + " " + quoted (GetParam ().output)), 1);
  EXPECT_EQ (folder.read (GetParam ().output), "of an earlier run");
  EXPECT_EQ (folder.count (), 2);
}

TEST_P (Apps, RefuseWrongUsage)
{
  folder.write ("good.pcd", GetParam ().good_cloud ());
  const std::string files = quoted ("good.pcd") + " " + quoted (GetParam ().output);
  std::vector<const char*> wrong = GetParam ().wrong_options;
  wrong.insert (wrong.end (), {"-no-such-option", "-threads -1", "-threads 2 -threads", "third_file.pcd"});
  for (const char* options : wrong) {
    SCOPED_TRACE (options);
    expectOneLine (runOn (files + " " + options), 2);
    EXPECT_EQ (folder.count (), 1);
  }
  expectOneLine (runOn (quoted ("good.pcd")), 2);
}

TEST_P (Apps, SayThatTheTableCannotBePrinted)
{
  folder.write ("good.pcd", GetParam ().good_cloud ());
  const Outcome outcome =
    run (logs, GetParam ().file, quoted ("good.pcd") + " " + quoted (GetParam ().output), {}, "/dev/full");
  EXPECT_EQ (outcome.exit_status, 1);
  EXPECT_TRUE (contains (outcome.error, "error: ")) << outcome.error;
}

TEST_P (Apps, PrintTheSameHelpWhenAskedOrWithoutArguments)
{
  const Outcome asked = runOn ("-h");
  const Outcome without = runOn ("");
  EXPECT_EQ (asked.exit_status, 0);
  EXPECT_EQ (without.exit_status, 0);
  EXPECT_EQ (asked.out, without.out);
  EXPECT_TRUE (contains (asked.out, GetParam ().name));
}

TEST_P (Apps, GoodInputGivesAllThatWasAskedFor)
{
  folder.write ("good.pcd", GetParam ().good_cloud ());
  const Outcome outcome =
    runOn (quoted ("good.pcd") + " " + quoted (GetParam ().output) + " -report " + quoted ("r.json"));
  EXPECT_EQ (outcome.exit_status, 0) << outcome.error;
  EXPECT_EQ (folder.count (), 3);
  EXPECT_FALSE (outcome.out.empty ());
}

} // namespace apps_contract
