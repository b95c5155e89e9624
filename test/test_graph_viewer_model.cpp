// What the viewer shows and what its keys change, without a window.
#include "graph_viewer_model.h"
#include "test_class_clouds.h"

#include <gtest/gtest.h>
#include <pcl/conversions.h>

#include <algorithm>
#include <limits>

namespace {

using namespace class_clouds;
using namespace pcl::manifold::apps;
using pcl::manifold::AdjacencyRule;
using pcl::manifold::FaceRule;
using pcl::manifold::GraphParameters;
using pcl::manifold::Status;
using Action = GraphViewerModel::Action;
using View = GraphViewerModel::View;

InputCloud
inputOf (const std::vector<Eigen::Vector3f>& points)
{
  InputCloud input;
  pcl::toPCLPointCloud2 (*cloudOf (points), input.cloud);
  return input;
}

GraphParameters
threeHops ()
{
  GraphParameters parameters;
  parameters.hops = 3;
  return parameters;
}

class Model : public testing::Test
{
protected:
  GraphViewerModel model{inputOf (torusAndKnot ()), threeHops ()};

  std::size_t corners () const
  {
    std::size_t count = 0;
    for (const Layer& layer : model.layers ())
      count += layer.corners.size ();
    return count;
  }

  std::size_t edges () const { return model.report ().curve.edges + model.report ().surface.edges; }
};

TEST_F (Model, ShowsOneViewAfterTheOther)
{
  EXPECT_EQ (model.status (), Status::OK);
  EXPECT_EQ (model.view (), View::CLOUD);
  EXPECT_EQ (model.press ("Left"), Action::NOTHING);
  EXPECT_EQ (corners (), torusAndKnot ().size ());
  std::vector<std::string> captions = {model.caption ()};
  for (const View view : {View::TILES, View::ADJACENCIES, View::FACES}) {
    EXPECT_EQ (model.press ("Right"), Action::REDRAW);
    EXPECT_EQ (model.view (), view);
    EXPECT_GT (corners (), 0U);
    captions.push_back (model.caption ());
  }
  EXPECT_EQ (model.press ("Right"), Action::NOTHING);
  EXPECT_EQ (captions, (std::vector<std::string>{"1/4  point cloud", "2/4  graph Voronoi diagram",
                                                 "3/4  adjacencies", "4/4  faces"}));
  EXPECT_EQ (model.press ("Left"), Action::REDRAW);
  EXPECT_EQ (model.view (), View::ADJACENCIES);
  EXPECT_EQ (model.panels ().size (), 4U);
}

TEST_F (Model, TheViewsShowWhatThereIs)
{
  const pcl::TopologyReport& report = model.report ();
  model.press ("Right");
  EXPECT_EQ (corners (), torusAndKnot ().size ()) << "every point is of a tile";
  model.press ("Right");
  EXPECT_EQ (corners (), 2 * edges () + model.landmarks ());
  model.press ("Right");
  std::size_t lines = 0;
  for (const Layer& layer : model.layers ())
    if (layer.kind == Layer::Kind::LINES)
      lines += layer.corners.size () / 2;
  EXPECT_GT (lines, 0U);
  EXPECT_EQ (lines, report.curve.edges);
}

TEST_F (Model, HopsMakeTheMeshCoarser)
{
  const std::size_t before = model.landmarks ();
  EXPECT_EQ (model.press ("Up"), Action::REDRAW);
  EXPECT_EQ (model.parameters ().hops, 4);
  EXPECT_LT (model.landmarks (), before);
  EXPECT_EQ (model.press ("Down"), Action::REDRAW);
  EXPECT_EQ (model.landmarks (), before);
  for (int i = 0; i < 2; ++i)
    model.press ("Down");
  EXPECT_EQ (model.parameters ().hops, 1);
  EXPECT_EQ (model.press ("Down"), Action::NOTHING);
  EXPECT_EQ (model.landmarks (), torusAndKnot ().size ());
}

TEST_F (Model, TheThresholdTakesAdjacenciesAway)
{
  const std::size_t before = edges ();
  for (int i = 0; i < 7; ++i)
    EXPECT_EQ (model.press ("A"), Action::REDRAW);
  EXPECT_EQ (model.parameters ().adjacency_threshold, 14);
  EXPECT_LT (edges (), before);
  for (int i = 0; i < 14; ++i)
    EXPECT_EQ (model.press ("a"), Action::REDRAW);
  EXPECT_EQ (model.press ("a"), Action::NOTHING);
}

TEST_F (Model, NeighborsChangeTheGraph)
{
  const std::size_t before = model.landmarks ();
  for (int i = 0; i < 10; ++i)
    EXPECT_EQ (model.press ("K"), Action::REDRAW);
  EXPECT_EQ (model.parameters ().k_search, 25);
  EXPECT_LT (model.landmarks (), before);
  for (int i = 0; i < 24; ++i)
    EXPECT_EQ (model.press ("k"), Action::REDRAW);
  EXPECT_EQ (model.press ("k"), Action::NOTHING);
  EXPECT_EQ (model.parameters ().k_search, 1);
}

TEST_F (Model, RulesTakeTurns)
{
  for (const AdjacencyRule rule :
       {AdjacencyRule::LINKING_EDGES, AdjacencyRule::CLEAR_PATH, AdjacencyRule::BOUNDARY_POINTS}) {
    EXPECT_EQ (model.press ("n"), Action::REDRAW);
    EXPECT_EQ (model.parameters ().adjacency_rule, rule);
  }
  for (const FaceRule rule : {FaceRule::SHORTEST_CYCLES, FaceRule::ROTATION_SYSTEM}) {
    EXPECT_EQ (model.press ("m"), Action::REDRAW);
    EXPECT_EQ (model.parameters ().face_rule, rule);
  }
}

TEST_F (Model, AsksTheWindowToSave)
{
  EXPECT_EQ (model.press ("F2"), Action::SAVE_MESH);
  EXPECT_EQ (model.press ("F3"), Action::SAVE_PICTURE);
  EXPECT_EQ (model.press ("z"), Action::NOTHING);
  EXPECT_EQ (model.press (""), Action::NOTHING);
  const pcl::PolygonMesh mesh = model.mesh ();
  EXPECT_FALSE (mesh.polygons.empty ());
  EXPECT_EQ (mesh.cloud.width, torusAndKnot ().size ());
}

TEST_F (Model, DescribesWhatItShows)
{
  const std::vector<std::string> lines = model.description ();
  ASSERT_EQ (lines.size (), 3U);
  EXPECT_EQ (lines[0], "k = 15, hops = 3, a = 7 by points, faces by rotation");
  EXPECT_NE (lines[2].find ("landmarks"), std::string::npos);
  EXPECT_NE (lines[2].find ("2 components"), std::string::npos) << lines[2];
}

TEST (ModelOfLittle, ShowsWhatCouldBeComputed)
{
  GraphViewerModel line (inputOf (grid (300, 1, 1)), GraphParameters ());
  EXPECT_EQ (line.status (), Status::DIMENSION_TOO_LOW);
  EXPECT_NE (line.description ().back ().find ("no face"), std::string::npos);
  EXPECT_TRUE (line.mesh ().polygons.empty ());
  EXPECT_EQ (line.panels ().size (), 4U);

  constexpr float NAN_VALUE = std::numeric_limits<float>::quiet_NaN ();
  GraphViewerModel nothing (inputOf (std::vector<Eigen::Vector3f> (5, {NAN_VALUE, 0.0f, 0.0f})),
                            GraphParameters ());
  EXPECT_EQ (nothing.status (), Status::NO_INPUT);
  EXPECT_EQ (nothing.description ().back (), "failed: NO_INPUT");
  for (const char* key : {"Right", "Right", "Right", "K", "Up", "A", "n", "m"})
    nothing.press (key);
  EXPECT_TRUE (nothing.layers ().empty ());
  EXPECT_TRUE (nothing.mesh ().polygons.empty ());
}

TEST (TileColours, DifferWhereTilesTouch)
{
  // A wheel: a hub and six tiles around it.
  std::vector<pcl::manifold::TileContact> contacts;
  for (pcl::index_t i = 1; i <= 6; ++i) {
    pcl::manifold::TileContact spoke;
    spoke.first = 0;
    spoke.second = i;
    contacts.push_back (spoke);
    pcl::manifold::TileContact rim;
    rim.first = std::min (i, i % 6 + 1);
    rim.second = std::max (i, i % 6 + 1);
    contacts.push_back (rim);
  }
  for (const std::size_t colours : {4U, 12U}) {
    const std::vector<std::size_t> colour_of = colourTiles (7, contacts, colours);
    for (const auto& contact : contacts)
      EXPECT_NE (colour_of[contact.first], colour_of[contact.second]);
  }
  EXPECT_EQ (colourTiles (3, {}, 12), (std::vector<std::size_t>{0, 1, 2}));
}

} // namespace
