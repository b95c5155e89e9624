// What the apps share apart from files: command line, failures, numbers, tables, progress.
#include "app_error.h"
#include "app_main.h"
#include "command_line.h"
#include "files/scalar_type.h"
#include "interrupt.h"
#include "mesh_distance.h"
#include "progress.h"
#include "report.h"
#include "summary.h"
#include "table.h"
#include "test_apps_folder.h"

#include <pcl/PCLPointField.h>

#include <cmath>
#include <csignal>
#include <cstring>
#include <limits>
#include <new>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <vector>

using namespace pcl::manifold;
using namespace pcl::manifold::apps;

namespace {

/** \brief An app with one option of each kind. */
struct App
{
  std::string input, output, name = "none";
  double rho = 0.3;
  int k = 0;
  std::uint64_t seed = 1;
  bool closed = false;
  CommonOptions common;
  CommandLine line{"some_app", "Does something."};
  std::string out, err;

  App ()
  {
    line.positional ("INPUT", "the cloud", input)
      .positional ("OUTPUT", "the result", output)
      .option ("rho", "r", "a ratio", rho, {0, 1})
      .option ("k", "k", "neighbours", k, {-5, 100})
      .option ("seed", "s", "seed", seed)
      .option ("name", "text", "a name\nof two lines", name)
      .flag ("closed", "close it", closed)
      .renamed ("old", "name")
      .common (common)
      .example ("some_app in.pcd out.pcd -rho 0.4");
  }

  int run (
    std::vector<const char*> arguments, const std::function<void ()>& body = [] {})
  {
    arguments.insert (arguments.begin (), "some_app");
    testing::internal::CaptureStdout ();
    testing::internal::CaptureStderr ();
    const int status = runApp (static_cast<int> (arguments.size ()), arguments.data (), line, body);
    out = testing::internal::GetCapturedStdout ();
    err = testing::internal::GetCapturedStderr ();
    return status;
  }
};

} // namespace

TEST (CommandLine, ReadsEveryKindOfOption)
{
  App app;
  EXPECT_EQ (
    app.run ({"-rho", "0.45", "in.pcd", "-k", "-3", "out.pcd", "--seed=18446744073709551615", "-closed",
              "-name", "-0.5", "-threads", "2", "-quiet", "-report", "r.json", "-picture=p.png"}),
    0);
  EXPECT_EQ (app.err, "");
  EXPECT_EQ (app.input, "in.pcd");
  EXPECT_EQ (app.output, "out.pcd");
  EXPECT_EQ (app.rho, 0.45);
  EXPECT_EQ (app.k, -3);
  EXPECT_EQ (app.seed, std::numeric_limits<std::uint64_t>::max ());
  EXPECT_EQ (app.name, "-0.5");
  EXPECT_TRUE (app.closed);
  EXPECT_EQ (app.common.threads, 2);
  EXPECT_TRUE (app.common.quiet);
  EXPECT_EQ (app.common.report, "r.json");
  EXPECT_EQ (app.common.picture, "p.png");
}

TEST (CommandLine, KeepsDefaults)
{
  App app;
  EXPECT_EQ (app.run ({"in.pcd", "out.pcd"}), 0);
  EXPECT_EQ (app.rho, 0.3);
  EXPECT_EQ (app.name, "none");
  EXPECT_FALSE (app.closed);
  EXPECT_FALSE (app.common.quiet);
  EXPECT_EQ (app.run ({"same.pcd", "same.pcd"}), 0) << "OUTPUT may be INPUT";
}

TEST (CommandLine, PrintsTheSameHelpForEveryRequest)
{
  App app;
  bool ran = false;
  EXPECT_EQ (app.run ({}, [&] { ran = true; }), 0);
  const std::string help = app.out;
  EXPECT_TRUE (contains (help, "Usage: some_app INPUT OUTPUT [-option value ...]\n"));
  EXPECT_TRUE (contains (help, "-rho r "));
  EXPECT_TRUE (contains (help, "a ratio (default 0.3)\n"));
  EXPECT_TRUE (contains (help, "some_app in.pcd out.pcd -rho 0.4\n"));
  for (const char* const request : {"-h", "-help", "--help"}) {
    EXPECT_EQ (app.run ({"in.pcd", request, "-rho"}, [&] { ran = true; }), 0);
    EXPECT_EQ (app.out, help);
    EXPECT_EQ (app.err, "");
  }
  EXPECT_FALSE (ran);
}

TEST (CommandLine, NamesWhatIsWrong)
{
  const std::vector<std::pair<std::vector<const char*>, std::string>> cases = {
    {{"in.pcd", "out.pcd", "-rho", "much"}, "error: -rho: 'much' is no number\n"},
    {{"in.pcd", "out.pcd", "-rho", "nan"}, "error: -rho: 'nan' is not from 0 to 1\n"},
    {{"in.pcd", "out.pcd", "-rho", "1.01"}, "error: -rho: '1.01' is not from 0 to 1\n"},
    {{"in.pcd", "out.pcd", "-k", "101"}, "error: -k: '101' is not from -5 to 100\n"},
    {{"in.pcd", "out.pcd", "-k", "2.5"}, "error: -k: '2.5' is no whole number that fits\n"},
    {{"in.pcd", "out.pcd", "-k", "99999999999"}, "error: -k: '99999999999' is no whole number that fits\n"},
    {{"in.pcd", "out.pcd", "-seed", "-1"}, "error: -seed: '-1' is no whole number that fits\n"},
    {{"in.pcd", "out.pcd", "-rho"}, "error: -rho: needs a value\n"},
    {{"in.pcd", "out.pcd", "-rho", "-k", "3"}, "error: -rho: needs a value\n"},
    {{"in.pcd", "out.pcd", "-rho="}, "error: -rho: needs a value\n"},
    {{"in.pcd", "out.pcd", "-closed=1"}, "error: -closed: takes no value\n"},
    {{"in.pcd", "out.pcd", "-k", "1", "-k", "2"}, "error: -k: given more than once\n"},
    {{"in.pcd", "out.pcd", "-wrong", "1"}, "error: -wrong: unknown option, see -h\n"},
    {{"in.pcd", "out.pcd", "--wrong"}, "error: -wrong: unknown option, see -h\n"},
    {{"in.pcd", "out.pcd", "-old", "x"}, "error: -old: unknown option, now -name, see -h\n"},
    {{"in.pcd", "out.pcd", "--old=x"}, "error: -old: unknown option, now -name, see -h\n"},
    {{"in.pcd", "out.pcd", "-clos"}, "error: -clos: unknown option, see -h\n"},
    {{"in.pcd", "out.pcd", "third"}, "error: 'third': one argument too many, see -h\n"},
    {{"in.pcd"}, "error: OUTPUT: missing, see -h\n"},
    {{"-quiet"}, "error: INPUT: missing, see -h\n"},
    {{"in.pcd", "out.pcd", "-picture", "a.jpg"}, "error: -picture: 'a.jpg' does not end in .png\n"},
    {{"in.pcd", ""}, "error: OUTPUT: is empty\n"},
    {{"in.pcd", "out.pcd", "-report", "./out.pcd"}, "error: -report: names the same file as OUTPUT\n"},
    {{"in.pcd", "out.pcd", "-report", "in.pcd"}, "error: -report: names the same file as INPUT\n"},
  };
  for (const auto& [arguments, message] : cases) {
    App app;
    EXPECT_EQ (app.run (arguments), 2) << message;
    EXPECT_EQ (app.err, message);
    EXPECT_EQ (app.out, "");
  }
}

TEST (App, TurnsEveryExceptionIntoOneLine)
{
  App app;
  EXPECT_EQ (app.run ({"in.pcd", "out"}, [] { throw AppError ("a.pcd", "line 3:\nbad"); }), 1);
  EXPECT_EQ (app.err, "error: a.pcd: line 3: bad\n");
  EXPECT_EQ (app.run ({"in.pcd", "out"}, [] { throw UsageError ("OUTPUT", "must end in .pcd"); }), 2);
  EXPECT_EQ (app.err, "error: OUTPUT: must end in .pcd\n");
  EXPECT_EQ (app.run ({"in.pcd", "out"}, [] { throw std::bad_alloc (); }), 1);
  EXPECT_EQ (app.err, "error: in.pcd: out of memory\n");
  EXPECT_EQ (app.run ({"in.pcd", "out"}, [] { throw std::logic_error ("odd"); }), 1);
  EXPECT_EQ (app.err, "error: in.pcd: odd\n");
  EXPECT_EQ (app.run ({"in.pcd", "out"}, [] { throw 5; }), 1);
  EXPECT_EQ (app.err, "error: in.pcd: unknown failure\n");
  EXPECT_EQ (app.run ({"in.pcd", "out"}, [] { requireOk ("in.pcd", pcl::manifold::Status::TOO_FEW_POINTS); }),
             1);
  EXPECT_EQ (app.err, "error: in.pcd: holds too few distinct points\n");
  EXPECT_EQ (app.run ({"in.pcd", "out"}, [] { requireOk ("in.pcd", pcl::manifold::Status::OK); }), 0);
}

TEST (Progress, PrintsALinePerTenPercent)
{
  testing::internal::CaptureStderr ();
  {
    Progress progress ("counting", false);
    const pcl::manifold::ProgressCallback callback = progress.callback ();
    for (int i = 0; i <= 1000; ++i)
      EXPECT_TRUE (callback (static_cast<float> (i) / 1000));
  }
  std::string expected;
  for (int percent = 0; percent <= 100; percent += 10)
    expected += "counting: " + std::to_string (percent) + " %\n";
  EXPECT_EQ (testing::internal::GetCapturedStderr (), expected);
}

TEST (Progress, IsSilentIfQuiet)
{
  testing::internal::CaptureStderr ();
  Progress ("counting", true).update (0.5f);
  EXPECT_EQ (testing::internal::GetCapturedStderr (), "");
}

TEST (Progress, CancelsAtTheFirstInterrupt)
{
  // In a process of its own: the signal is noted for good.
  EXPECT_EXIT (
    {
      noteInterrupts ();
      Progress progress ("counting", true);
      const bool before = progress.update (0.1f);
      raise (SIGINT);
      const bool after = progress.update (0.2f);
      const std::string message = messageOf<AppError> ([] { throwIfInterrupted ("in.pcd"); });
      std::_Exit (before && !after && message == "in.pcd: cancelled" ? 7 : 8);
    },
    testing::ExitedWithCode (7), "");
  EXPECT_EXIT (
    {
      noteInterrupts ();
      raise (SIGINT);
      raise (SIGINT);
    },
    testing::KilledBySignal (SIGINT), "");
}

TEST (Numbers, AreReadWholeOrNotAtAll)
{
  double number = 7;
  for (const char* const text : {"", "-", "+", "+-1", "1x", "0x10", "1,5", " 1", "1 ", "--1", "e5", "."})
    EXPECT_FALSE (parseNumber (std::string_view (text), number)) << text;
  EXPECT_EQ (number, 7);
  const std::vector<std::pair<const char*, double>> numbers = {
    {"0", 0},
    {"-1.5", -1.5},
    {"+2", 2},
    {".5", 0.5},
    {"1e3", 1000},
    {"0.1", 0.1},
    {"1e999", std::numeric_limits<double>::infinity ()},
    {"-inf", -std::numeric_limits<double>::infinity ()},
    {"1e-999", 0}};
  for (const auto& [text, value] : numbers) {
    EXPECT_TRUE (parseNumber (std::string_view (text), number)) << text;
    EXPECT_EQ (number, value) << text;
  }
  for (const char* const text : {"NaN", "1.#QNAN", "-1.#IND", "1.#IND00", "1.#SNAN0", "-nan(ind)"}) {
    number = 7;
    EXPECT_TRUE (parseNumber (std::string_view (text), number)) << text;
    EXPECT_NE (number, number) << text;
  }
  for (const char* const text : {"1.#INF", "+1.#INF00", "-1.#INF"}) {
    EXPECT_TRUE (parseNumber (std::string_view (text), number)) << text;
    EXPECT_EQ (number, text[0] == '-' ? -HUGE_VAL : HUGE_VAL) << text;
  }
  for (const char* const text : {"1.#", "1.#QNANX", "1.#IN", "2.#INF", "-", "1.#IND1"})
    EXPECT_FALSE (parseNumber (std::string_view (text), number)) << text;
  // Beyond the range of a double, whatever says so: the exponent or the digits.
  const std::string zeros (400, '0');
  for (const std::string& text : {std::string ("1e999"), "1" + zeros, "0." + zeros + "1e900",
                                  "1" + zeros + "e-50", std::string ("1e+99999999999999999999")}) {
    EXPECT_TRUE (parseNumber (std::string_view (text), number)) << text;
    EXPECT_EQ (number, HUGE_VAL) << text;
  }
  for (const std::string& text : {std::string ("1e-999"), "0." + zeros + "1", "1" + zeros + "e-900",
                                  std::string ("-1e-99999999999999999999")}) {
    number = 7;
    EXPECT_TRUE (parseNumber (std::string_view (text), number)) << text;
    EXPECT_EQ (number, 0) << text;
  }
  float narrow = 0;
  EXPECT_TRUE (parseNumber (std::string_view ("-1e50"), narrow));
  EXPECT_EQ (narrow, -HUGE_VALF);
  EXPECT_TRUE (parseNumber (std::string_view ("1e-45"), narrow));
  EXPECT_EQ (narrow, std::numeric_limits<float>::denorm_min ());
}

TEST (Numbers, FitTheirField)
{
  std::uint8_t bytes[8] = {};
  EXPECT_TRUE (parseValue ("255", pcl::PCLPointField::UINT8, bytes));
  EXPECT_EQ (toDouble (pcl::PCLPointField::UINT8, bytes), 255);
  EXPECT_FALSE (parseValue ("256", pcl::PCLPointField::UINT8, bytes));
  EXPECT_FALSE (parseValue ("-1", pcl::PCLPointField::UINT8, bytes));
  EXPECT_FALSE (parseValue ("1.5", pcl::PCLPointField::INT16, bytes));
  EXPECT_TRUE (parseValue ("-3e2", pcl::PCLPointField::INT16, bytes));
  EXPECT_EQ (toDouble (pcl::PCLPointField::INT16, bytes), -300);
  EXPECT_FALSE (parseValue ("nan", pcl::PCLPointField::INT32, bytes));
  EXPECT_FALSE (parseValue ("18446744073709551616", pcl::PCLPointField::UINT64, bytes));
  EXPECT_TRUE (parseValue ("16777217", pcl::PCLPointField::UINT32, bytes));
  EXPECT_EQ (toDouble (pcl::PCLPointField::UINT32, bytes), 16777217);
}

TEST (Table, AlignsItsColumns)
{
  Table table;
  table.row ("points", std::size_t (1234567));
  table.row ("time", 1.5, "s");
  table.row ("a longer name", "two\nlines");
  std::ostringstream text;
  table.print (text);
  EXPECT_EQ (text.str (), "  points         1 234 567\n"
                          "  time           1.500 s\n"
                          "  a longer name  two\n"
                          "                 lines\n");
}

TEST (MeshDistance, IsThatToTheNearestTriangle)
{
  // A square in the plane z = 1, of two triangles, and a point of no triangle.
  Eigen::Matrix3Xd points (3, 5);
  points << 0, 1, 1, 0, NAN, 0, 0, 1, 1, NAN, 1, 1, 1, 1, NAN;
  const std::vector<pcl::SimplicialComplex::Triangle> triangles = {{0, 1, 2}, {0, 2, 3}};
  const TriangleMesh mesh{points, triangles};
  EXPECT_DOUBLE_EQ (meanEdge (mesh), (4 + 2 * std::sqrt (2)) / 6);
  EXPECT_EQ (meanEdge ({points, {}}), 0);
  EXPECT_EQ (largestDistance (Eigen::Matrix3Xd (3, 0), mesh), 0);
  EXPECT_EQ (largestDistance (placesOn (mesh, 0.1), mesh), 0);
  Eigen::Matrix3Xd places (3, 3);
  places << 0.25, 0.75, 0.5, 0.5, 0.5, 0.5, 1, 3.5, -1;
  EXPECT_DOUBLE_EQ (largestDistance (places, mesh), 2.5) << "over a face";
  places.col (0) = Eigen::Vector3d (4, 5, 1);
  EXPECT_DOUBLE_EQ (largestDistance (places, mesh), 5) << "beside a corner";
}

TEST (MeshDistance, PlacesAreAsDenseAsAskedFor)
{
  const Eigen::Matrix3Xd points = Eigen::Matrix3d::Identity ();
  const std::vector<pcl::SimplicialComplex::Triangle> triangles = {{0, 1, 2}};
  EXPECT_EQ (placesOn ({points, triangles}, 100).cols (), 6);
  EXPECT_EQ (placesOn ({points, triangles}, std::sqrt (2) / 4.5).cols (), 21);
  EXPECT_EQ (placesOn ({points, triangles}, 1e-9).cols (), 65 * 66 / 2);
  EXPECT_EQ (placesOn ({points, {}}, 1).cols (), 0);
}

TEST (Summary, SaysWhatWasLeftOut)
{
  EXPECT_EQ (inWords (PointCounts{0, 0, 0, 0, 0}), "0 points, none left out");
  EXPECT_EQ (inWords (PointCounts{1, 0, 0, 0, 1}), "1 point, none left out");
  EXPECT_EQ (inWords (PointCounts{4000, 3, 0, 1996, 2001}),
             "4 000 points, left out 3 not finite, 1 996 thinned: 2 001 samples");
  EXPECT_EQ (inWords (PointCounts{3, 0, 2, 0, 1}), "3 points, left out 2 duplicate: 1 sample");
}

TEST (Summary, SaysHowManyPartsThereAreAndOfWhichKind)
{
  using Lines = std::vector<std::string>;
  const auto say = [] (const pcl::SimplicialComplex& complex) {
    return inWords (pcl::manifold::analyze (complex));
  };
  pcl::SimplicialComplex complex;
  EXPECT_EQ (say (complex), Lines{"nothing: no edge, triangle or tetrahedron"});
  const std::vector<pcl::SimplicialComplex::Triangle> sphere = {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {0, 2, 3}};
  complex.triangles = sphere;
  EXPECT_EQ (say (complex), Lines{"surface in one part, closed, of genus 0"});
  complex.triangles.pop_back ();
  EXPECT_EQ (say (complex), Lines{"surface in one part, open with 1 boundary loop, of genus 0"});
  complex.triangles.insert (complex.triangles.end (), {{4, 5, 6}, {7, 8, 9}});
  EXPECT_EQ (say (complex),
             Lines{"surface in 3 parts, 3 open with 3 boundary loops; the largest has 60 % of the faces"});
  complex.triangles = sphere;
  complex.triangles.push_back ({0, 1, 4});
  EXPECT_EQ (say (complex), (Lines{"surface in one part, open with 1 boundary loop",
                                   "surface not manifold at 1 edge and 2 vertices"}));
  complex.triangles.clear ();
  for (int i = 0; i < 5; ++i) // a Moebius band of five triangles
    complex.triangles.push_back ({i, (i + 1) % 5, (i + 2) % 5});
  EXPECT_EQ (say (complex), (Lines{"surface in one part, open with 1 boundary loop, with 1 crosscap",
                                   "surface one-sided in 1 part: no way to orient all of its triangles"}));
  complex.triangles.clear ();
  complex.edges = {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {4, 6}};
  complex.tetrahedra = {{7, 8, 9, 10}};
  EXPECT_EQ (say (complex),
             (Lines{"2 curves, 1 closed, 1 open", "curves branch at 1 vertex", "1 solid of 1 tetrahedron",
                    "skin of the solids in one part, closed, of genus 0"}));
}

TEST (Report, EndsWithItsSummaryAndItsTable)
{
  const TestFolder folder;
  Report report ("some_app");
  report.say ({"first", "second"});
  Table table;
  table.row ("points", std::size_t (3));
  CommonOptions options;
  options.report = folder / "r.json";
  testing::internal::CaptureStdout ();
  report.finish (options, table);
  EXPECT_EQ (testing::internal::GetCapturedStdout (), "first\nsecond\n  points  3\n");
  EXPECT_TRUE (contains (folder.read ("r.json"), "\"summary\"")) << folder.read ("r.json");
  options.quiet = true;
  testing::internal::CaptureStdout ();
  report.finish (options, table);
  EXPECT_EQ (testing::internal::GetCapturedStdout (), "");
}
