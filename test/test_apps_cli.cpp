// The apps of the Delaunay family as a user runs them.
#include "test_apps_contract.h"

namespace {

using namespace apps_contract;

/** Points scattered in a box: something to work on. */
std::string
goodPcd ()
{
  constexpr int POINTS = 600;
  std::string data;
  for (int i = 0; i < POINTS; ++i)
    data += std::to_string ((i * 37) % 101) + " " + std::to_string ((i * i) % 89) + " " +
            std::to_string ((i * 53) % 97) + "\n";
  return pcd (POINTS, data);
}

const std::vector<const char*> WRONG = {"-rho 0",        "-rho nan",          "-rho 2",    "-rho three",
                                        "-rho",          "-thin -1",          "-thin 2.5", "-thin five",
                                        "-thin 5 -thin", "-thin-distance -1", "-k 5",      "-spacing 1"};

INSTANTIATE_TEST_SUITE_P (
  Both, Apps,
  testing::Values (App{"pcl_dimension_detection", DIMENSION_DETECTION_APP, "out.pcd", goodPcd, WRONG},
                   App{"pcl_cocone_shape", COCONE_SHAPE_APP, "out.ply", goodPcd, WRONG},
                   App{"pcl_cocone_shape", COCONE_SHAPE_APP, "out.vtu", goodPcd, WRONG}),
  [] (const auto& tested) { return nameOf (tested.param); });

TEST_P (Apps, NameTheOptionThatIsCalledOtherwiseNow)
{
  folder.write ("good.pcd", goodPcd ());
  const Outcome outcome = runOn (quoted ("good.pcd") + " " + quoted (GetParam ().output) + " -k 4");
  EXPECT_EQ (outcome.error, "error: -k: unknown option, now -thin, see -h\n");
}

TEST_P (Apps, SayInWordsWhatTheyDid)
{
  folder.write ("good.pcd", pcd (5, "0 0 0\n1 0 0\n0 1 0\n0 0 0\nnan 1 2\n"));
  const Outcome outcome =
    runOn (quoted ("good.pcd") + " " + quoted (GetParam ().output) + " -report " + quoted ("r.json"));
  ASSERT_EQ (outcome.exit_status, 0) << outcome.error;
  const std::string line = "5 points, left out 1 not finite, 1 duplicate: 3 samples";
  EXPECT_EQ (outcome.out.rfind (line + "\n", 0), 0U) << outcome.out;
  EXPECT_TRUE (contains (folder.read ("r.json"), '"' + line + '"'));
}

} // namespace
