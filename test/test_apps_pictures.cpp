// Pictures, drawn without a display.
#include "app_error.h"
#include "complex_layers.h"
#include "files/cloud_fields.h"
#include "offscreen_window.h"
#include "picture.h"
#include "test_apps_folder.h"
#include "test_apps_png.h"
#include "view.h"

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <future>
#include <limits>
#include <stdexcept>

#ifdef __SANITIZE_ADDRESS__
// The drivers of OpenGL leak.
extern "C" __attribute__ ((visibility ("default"))) const char* __asan_default_options ();
const char*
__asan_default_options ()
{
  return "detect_leaks=0";
}
#endif

using namespace pcl::manifold;
using namespace pcl::manifold::apps;

namespace {

/** \brief A sphere with a circle around it, of the given size, somewhere. */
std::vector<Panel>
someScene (float size, float offset)
{
  constexpr int rows = 20, columns = 40;
  auto positions = std::make_shared<Positions> ();
  Layer triangles;
  triangles.kind = Layer::Kind::TRIANGLES;
  triangles.name = "surface";
  triangles.smooth = true;
  triangles.colour = dimensionColour (2);
  for (int row = 0; row <= rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const double polar = M_PI * row / rows, azimuth = 2 * M_PI * column / columns;
      positions->push_back ({offset + size * static_cast<float> (std::sin (polar) * std::cos (azimuth)),
                             offset + size * static_cast<float> (std::sin (polar) * std::sin (azimuth)),
                             size * static_cast<float> (std::cos (polar))});
      const int a = row * columns + column, b = row * columns + (column + 1) % columns;
      if (row < rows)
        triangles.corners.insert (triangles.corners.end (), {a, a + columns, b, b, a + columns, b + columns});
    }
  positions->push_back ({std::numeric_limits<float>::quiet_NaN (), 0, 0});
  const auto last = static_cast<std::int32_t> (positions->size ()) - 1;
  triangles.corners.insert (triangles.corners.end (), {0, 1, last});
  triangles.positions = positions;
  Layer lines;
  lines.kind = Layer::Kind::LINES;
  lines.name = "curve";
  lines.colour = dimensionColour (1);
  lines.positions = positions;
  for (int column = 0; column < columns; ++column)
    lines.corners.insert (lines.corners.end (), {rows / 2 * columns + column, last - 1 - column});
  std::vector<std::uint8_t> dimensions (positions->size ());
  for (std::size_t i = 0; i < dimensions.size (); ++i)
    dimensions[i] = static_cast<std::uint8_t> (i % 5);
  return {{"points", layersByDimension (positions, dimensions)}, {"mesh", {triangles, lines}}};
}

class Pictures : public testing::Test
{
protected:
  // There is no such display, and pictures need none.
  void SetUp () override { setenv ("DISPLAY", "nowhere:0", 1); } // NOLINT(concurrency-mt-unsafe)
};

} // namespace

TEST_F (Pictures, AreDrawnWhateverTheScale)
{
  const TestFolder folder;
  std::size_t blank = 0;
  {
    const Picture picture (folder / "blank.png");
    picture.draw ("nothing", {{"", {}}});
    blank = folder.read ("blank.png").size ();
  }
  for (const auto& [size, offset] :
       {std::pair (1.0f, 0.0f), std::pair (1e-30f, 0.0f), std::pair (1e30f, 0.0f), std::pair (10.0f, 5e6f)}) {
    const Picture picture (folder / "a.png");
    EXPECT_TRUE (picture.wanted ());
    picture.draw ("a title, M\xc3\xb6"
                  "bius, \xff",
                  someScene (size, offset));
    const std::string png = folder.read ("a.png");
    expectPng (png, 1600, 900);
    EXPECT_GT (png.size (), 4 * blank) << size;
  }
  EXPECT_EQ (folder.count (), 2);
}

TEST_F (Pictures, HaveTheSizeThatWasAskedFor)
{
  const TestFolder folder;
  const Picture picture (folder / "a.png");
  picture.draw ("small", someScene (1, 0), 640, 480);
  expectPng (folder.read ("a.png"), 640, 480);
}

TEST_F (Pictures, AreTheSameEachTime)
{
  const TestFolder folder;
  for (const char* const name : {"a.png", "b.png"})
    Picture (folder / name).draw ("again", someScene (1, 0), 640, 480);
  EXPECT_TRUE (folder.read ("a.png") == folder.read ("b.png"));
}

TEST_F (Pictures, AreDrawnInAnyThread)
{
  const TestFolder folder;
  const Picture picture (folder / "a.png");
  std::async (std::launch::async, [&] {
    Picture (folder / "b.png").draw ("again", someScene (1, 0), 640, 480);
  }).get ();
  picture.draw ("again", someScene (1, 0), 640, 480);
  EXPECT_TRUE (folder.read ("a.png") == folder.read ("b.png"));
}

TEST (ComplexLayers, ShowEveryDimension)
{
  pcl::PCLPointCloud2 cloud;
  cloud.width = 5;
  cloud.height = 1;
  for (const char* const axis : {"z", "y", "x"})
    appendField (cloud, axis, pcl::PCLPointField::FLOAT32);
  allocatePoints (cloud);
  const float z = 7;
  std::memcpy (&cloud.data[cloud.point_step], &z, sizeof (z));
  const std::shared_ptr<const Positions> positions = positionsOf (cloud);
  EXPECT_EQ (positions->size (), 5u);
  EXPECT_EQ ((*positions)[1], (std::array<float, 3>{0, 0, 7}));
  pcl::SimplicialComplex complex;
  complex.edges = {{0, 1}, {1, 2}};
  complex.tetrahedra = {{0, 1, 2, 3}, {1, 2, 3, 4}};
  const std::vector<Layer> layers = layersOf (positions, complex);
  ASSERT_EQ (layers.size (), 2u);
  EXPECT_EQ (layers[0].kind, Layer::Kind::LINES);
  EXPECT_EQ (layers[0].name, "curve: 2 edges");
  EXPECT_EQ (layers[0].corners, (std::vector<std::int32_t>{0, 1, 1, 2}));
  EXPECT_EQ (layers[1].kind, Layer::Kind::TRIANGLES);
  EXPECT_EQ (layers[1].name, "solid: 2 tetrahedra");
  EXPECT_EQ (layers[1].corners.size (), 6u * 3);
}

TEST (Picture, IsNotDrawnUnlessWanted)
{
  const Picture picture ("");
  EXPECT_FALSE (picture.wanted ());
  picture.draw ("nothing", {});
}

TEST (PictureDeathTest, IsRefusedEarly)
{
  const TestFolder folder;
  EXPECT_TRUE (
    contains (messageOf<AppError> ([&] { Picture (folder / "none/a.png"); }), "there is no folder"));
  // EGL looks for its drivers where this says, and finds none.
  const std::string file = folder / "a.png";
  EXPECT_EXIT (
    {
      setenv ("__EGL_VENDOR_LIBRARY_DIRS", (folder / "").c_str (), 1); // NOLINT(concurrency-mt-unsafe)
      const std::string line = messageOf<AppError> ([&file] { const Picture picture (file); });
      std::fputs (line.c_str (), stderr);
      std::_Exit (7);
    },
    testing::ExitedWithCode (7),
    "a.png: a picture needs OpenGL 3.2 from EGL: install libegl1 and libgl1-mesa-dri");
  EXPECT_EQ (folder.count (), 0);
}

TEST (View, HoldsAllCornersAndSeesFlatScenesFromTheSide)
{
  std::vector<std::array<double, 3>> corners (1000);
  for (int i = 0; i < 1000; ++i) { // a wall along y
    const int row = i / 40;
    corners[i] = {0, (i % 40 - 20) / 20.0, (row - 12) / 12.0};
  }
  const double aspect = 1.5;
  const View view = chooseView (corners, aspect);
  double highest = 0;
  for (const auto& corner : corners) {
    double right = 0, up = 0;
    for (int axis = 0; axis < 3; ++axis) {
      right += (corner[axis] - view.centre[axis]) * view.right[axis];
      up += (corner[axis] - view.centre[axis]) * view.up[axis];
    }
    EXPECT_LE (std::abs (right), view.half_height * aspect);
    EXPECT_LE (std::abs (up), view.half_height);
    highest = std::max (highest, std::abs (up));
  }
  EXPECT_GT (highest, 0.8 * view.half_height);
  EXPECT_GT (std::abs (view.towards[0]), 0.7);
  EXPECT_LT (view.towards[2], 0);
  chooseView ({}, aspect);
  EXPECT_GT (chooseView ({{1, 1, 1}}, aspect).half_height, 0);
}
