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

const std::vector<const char*> WRONG = {"-rho 0", "-rho nan", "-rho 2", "-rho three", "-rho", "-spacing -1"};

INSTANTIATE_TEST_SUITE_P (
  Both, Apps,
  testing::Values (App{"pcl_dimension_detection", DIMENSION_DETECTION_APP, "out.pcd", goodPcd, WRONG},
                   App{"pcl_cocone_shape", COCONE_SHAPE_APP, "out.ply", goodPcd, WRONG},
                   App{"pcl_cocone_shape", COCONE_SHAPE_APP, "out.vtu", goodPcd, WRONG}),
  [] (const auto& tested) { return nameOf (tested.param); });

} // namespace
