// Clouds of the kinds that users of other tools reported, through the apps. field_cases/README.md says what
// each is.
#include "field_case.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <ostream>
#include <string>

namespace {

using namespace field_case;

enum class App
{
  DIMENSION,
  SHAPE,
  FIXED_POINT
};

struct FieldCase
{
  const char* file;
  App app;
  Expectation expectation;

  friend std::ostream& operator<< (std::ostream& stream, const FieldCase& tested)
  {
    return stream << tested.file;
  }
};

class FieldCases : public testing::TestWithParam<FieldCase>
{};

TEST_P (FieldCases, AreRight)
{
  const TestFolder folder;
  const FieldCase& tested = GetParam ();
  const char* app = tested.app == App::DIMENSION ? DIMENSION_DETECTION_APP
                    : tested.app == App::SHAPE   ? COCONE_SHAPE_APP
                                                 : FIXED_POINT_RECONSTRUCTION_APP;
  const Result result =
    run (folder, app, std::string (FIELD_CASES) + "/" + tested.file, tested.app != App::DIMENSION);
  EXPECT_EQ (tested.expectation (result), "");
}

const FieldCase table[] = {
  {"01-lidr-planes-lines/in.pcd", App::DIMENSION, labels (0.985)},
  {"03-two-squares/near.pcd", App::SHAPE, surface (2, 2, 0)},
  {"06-tiny-solids/box8.pcd", App::SHAPE, surface (1, 0, 0)},
  {"06-tiny-solids/ico12.pcd", App::SHAPE, surface (1, 0, 0)},
  {"06-tiny-solids/boxgrid.pcd", App::FIXED_POINT, surface (1, 0, 0)},
  {"09-disparity-steps/integer.pcd", App::FIXED_POINT, surface (1, 1, 0)},
  {"10-cavity/in.pcd", App::SHAPE, surface (2, 0, 0)},
  {"11-two-rings/in.pcd", App::SHAPE, polylines (2, 0.1f)},
  {"13-ply-vertex-list/list_first.ply", App::DIMENSION, fields ({"rgb"})},
  {"13-ply-vertex-list/descriptor.ply", App::DIMENSION, fields ({"descriptor"})},
  {"14-ply-camera/nonewline.ply", App::SHAPE, surface (1, 0, 0)},
  {"14-ply-camera/camera_first.ply", App::SHAPE, surface (1, 0, 0)},
  {"15-ply-face0/in.ply", App::SHAPE, surface (1, 0, 0)},
  {"16-ply-value-a-line/in.ply", App::SHAPE, surface (1, 0, 0)},
  {"17-ply-line-ends/crlf_blank.ply", App::SHAPE, surface (1, 0, 0)},
  {"17-ply-line-ends/crlf_binary.ply", App::SHAPE, surface (1, 0, 0)},
  {"17-ply-line-ends/endheader_space.ply", App::SHAPE, surface (1, 0, 0)},
  {"17-ply-line-ends/lsd_end_header.ply", App::DIMENSION, fails ()},
  {"18-utm-commas/in.txt", App::SHAPE, surface (1, 0, 0)},
  {"20-decimal-comma/ascii.ply", App::DIMENSION, fails ()},
  {"21-pcd-crlf/binary.pcd", App::SHAPE, surface (1, 0, 0)},
  {"21-pcd-crlf/ascii.pcd", App::SHAPE, surface (1, 0, 0)},
  {"21-pcd-crlf/v.7.pcd", App::DIMENSION, header ("\nVIEWPOINT -1.4 0.2 7.5 ")},
  {"23-pcd-header-faults/livox.pcd", App::DIMENSION, fails ()},
  {"23-pcd-header-faults/empty_map.pcd", App::DIMENSION, fails ()},
  {"24-ptx-pts-text/pts.txt", App::SHAPE, surface (1, 0, 0)},
  {"25-nodata/m9999.pcd", App::SHAPE, surface (2, 2, 0)},
  {"26-utm-sentinel/utm_float.pcd", App::DIMENSION, fails ()},
  {"27-tower-and-wires/wires_0.pcd", App::SHAPE, polylines (3, 0.5f)},
  {"29-voxel-masks/two_balls.pcd", App::SHAPE, solid ({0, 0}, 2042.0)},
  {"30-uneven-density/in.pcd", App::SHAPE, surface (1, 0, 0)},
  {"31-lathe-poles/lathe.pcd", App::FIXED_POINT, surface (1, 0, 0)},
  {"31-lathe-poles/uvsphere_160x40.pcd", App::FIXED_POINT, surface (1, 0, 0)},
  {"32-marching-cubes/in.pcd", App::SHAPE, surface (1, 0, 0)},
  {"33-thin-plate/t2.pcd", App::SHAPE, surface (1, 0, 0)},
  {"34-voxelgrid-box/paper.pcd", App::SHAPE, surface (1, 1, 0)},
  // The open ends of a pipe two spacings thick may be closed.
  {"36-pipes/full_r2.pcd", App::SHAPE, either (surface (1, 2, 0), surface (1, 0, 0))},
};

INSTANTIATE_TEST_SUITE_P (Apps, FieldCases, testing::ValuesIn (table), [] (const auto& tested) {
  std::string name = std::string (tested.param.app == App::DIMENSION ? "dimension_"
                                  : tested.param.app == App::SHAPE   ? "shape_"
                                                                     : "fixed_point_") +
                     tested.param.file;
  std::replace_if (
    name.begin (), name.end (), [] (unsigned char c) { return std::isalnum (c) == 0; }, '_');
  return name;
});

} // namespace
