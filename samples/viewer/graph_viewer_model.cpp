#include "graph_viewer_model.h"

#include "complex_layers.h"
#include "graph_options.h"
#include "table.h"

#include <pcl/manifold/sample_set.h>

#include <algorithm>
#include <iomanip>
#include <sstream>

namespace pcl::manifold::apps {
namespace {

using View = GraphViewerModel::View;

constexpr int VIEWS = 4;
constexpr int MOST_NEIGHBORS = 200;
constexpr int MOST_HOPS = 200;
constexpr int LARGEST_THRESHOLD = 100000;

std::string
secondsOf (const std::vector<Stage>& stages)
{
  double seconds = 0.0;
  for (const Stage& stage : stages)
    seconds += stage.seconds;
  std::ostringstream text;
  text << std::fixed << std::setprecision (2) << seconds << " s";
  return text.str ();
}

Eigen::MatrixXd
matrixOf (const Positions& positions)
{
  Eigen::MatrixXd points (3, static_cast<Eigen::Index> (positions.size ()));
  for (std::size_t i = 0; i < positions.size (); ++i)
    for (std::size_t axis = 0; axis < 3; ++axis)
      points (static_cast<Eigen::Index> (axis), static_cast<Eigen::Index> (i)) = positions[i][axis];
  return points;
}

/** \brief The rule after another one, the first after the last. */
template <typename Rule>
Rule
nextRule (Rule rule, int rules)
{
  return static_cast<Rule> ((static_cast<int> (rule) + 1) % rules);
}

} // namespace

GraphViewerModel::GraphViewerModel (const InputCloud& input, const GraphParameters& parameters)
  : cloud_ (input.cloud), positions_ (positionsOf (input.cloud)), parameters_ (parameters)
{
  computeGraph ();
}

void
GraphViewerModel::computeGraph ()
{
  StageLog log;
  graph_status_ = makeCloudGraph (matrixOf (*positions_), {}, FLOAT_RESOLUTION, parameters_.k_search, {},
                                  parameters_.threads, log, graph_);
  log.begin ("", 1.0f);
  graph_stages_ = log.stages ();
  computeMesh ();
}

void
GraphViewerModel::computeMesh ()
{
  StageLog log;
  result_ = GraphMesh ();
  status_ = graph_status_;
  if (status_ == Status::OK)
    status_ = reconstructGraph (graph_.graph, graph_.points, parameters_, log, result_);
  mesh_stages_ = log.stages ();
  landmarks_.clear ();
  for (const pcl::index_t vertex : result_.landmarks)
    landmarks_.push_back (graph_.input_index[vertex]);
  tiles_.assign (positions_->size (), -1);
  if (!result_.tiles.empty ())
    for (std::size_t i = 0; i < tiles_.size (); ++i)
      if (graph_.vertex_of[i] >= 0)
        tiles_[i] = result_.tiles[graph_.vertex_of[i]];
}

GraphViewerModel::Action
GraphViewerModel::change (int& parameter, int step, int low, int high, bool graph_too)
{
  const int changed = std::clamp (parameter + step, low, high);
  if (changed == parameter)
    return Action::NOTHING;
  parameter = changed;
  if (graph_too)
    computeGraph ();
  else
    computeMesh ();
  return Action::REDRAW;
}

GraphViewerModel::Action
GraphViewerModel::show (int step)
{
  const int changed = std::clamp (static_cast<int> (view_) + step, 0, VIEWS - 1);
  if (changed == static_cast<int> (view_))
    return Action::NOTHING;
  view_ = static_cast<View> (changed);
  return Action::REDRAW;
}

GraphViewerModel::Action
GraphViewerModel::press (const std::string& key)
{
  if (key == "Right" || key == "Left")
    return show (key == "Right" ? 1 : -1);
  if (key == "Up" || key == "Down")
    return change (parameters_.hops, key == "Up" ? 1 : -1, 1, MOST_HOPS, false);
  if (key == "A" || key == "a")
    return change (parameters_.adjacency_threshold, key == "A" ? 1 : -1, 0, LARGEST_THRESHOLD, false);
  if (key == "K" || key == "k")
    return change (parameters_.k_search, key == "K" ? 1 : -1, 1, MOST_NEIGHBORS, true);
  if (key == "n" || key == "m") {
    if (key == "n")
      parameters_.adjacency_rule = nextRule (parameters_.adjacency_rule, 3);
    else
      parameters_.face_rule = nextRule (parameters_.face_rule, 2);
    computeMesh ();
    return Action::REDRAW;
  }
  if (key == "F2")
    return Action::SAVE_MESH;
  return key == "F3" ? Action::SAVE_PICTURE : Action::NOTHING;
}

bool
GraphViewerModel::knows (const std::string& key)
{
  static const std::vector<std::string> keys = {"Right", "Left", "Up", "Down", "A",  "a", "K",
                                                "k",     "n",    "m",  "F2",   "F3", "r", "q"};
  return std::find (keys.begin (), keys.end (), key) != keys.end ();
}

const std::vector<std::string>&
GraphViewerModel::help ()
{
  static const std::vector<std::string> lines = {
    "Left, Right   cloud, tiles, adjacencies, faces",
    "Down, Up      fewer, more hops between landmarks",
    "a, A          smaller, larger adjacency threshold",
    "k, K          fewer, more neighbours of a point",
    "n             next adjacency rule",
    "m             next face rule",
    "F2            save the mesh",
    "F3            save the picture of all four",
    "r             see all of it again",
    "q             quit",
  };
  return lines;
}

GraphStages
GraphViewerModel::stages () const
{
  return {positions_, tiles_, landmarks_, result_.contacts, result_.mesh};
}

std::vector<Layer>
GraphViewerModel::layers () const
{
  switch (view_) {
    case View::CLOUD:
      return cloudLayers (stages ());
    case View::TILES:
      return tileLayers (stages ());
    case View::ADJACENCIES:
      return adjacencyLayers (stages ());
    case View::FACES:
      break;
  }
  return faceLayers (stages ());
}

std::vector<Panel>
GraphViewerModel::panels () const
{
  return graphPanels (stages ());
}

std::string
GraphViewerModel::caption () const
{
  static const char* const names[VIEWS] = {"point cloud", "graph Voronoi diagram", "adjacencies", "faces"};
  return std::to_string (static_cast<int> (view_) + 1) + "/" + std::to_string (VIEWS) + "  " +
         names[static_cast<int> (view_)];
}

std::vector<std::string>
GraphViewerModel::description () const
{
  std::vector<std::string> lines = {
    "k = " + std::to_string (parameters_.k_search) + ", hops = " + std::to_string (parameters_.hops) +
      ", a = " + std::to_string (parameters_.adjacency_threshold) + " by " +
      nameOf (parameters_.adjacency_rule) + ", faces by " + nameOf (parameters_.face_rule),
    "graph " + secondsOf (graph_stages_) + ", all else " + secondsOf (mesh_stages_)};
  const SurfaceTopology& surface = result_.report.surface;
  const std::string mesh = grouped (result_.landmarks.size ()) + " landmarks, " +
                           grouped (result_.mesh.edges.size ()) + " adjacencies, ";
  if (status_ == Status::OK)
    lines.push_back (mesh + grouped (surface.faces) + " faces, " +
                     (surface.components.size () == 1 && surface.components[0].genus >= 0
                        ? "genus " + std::to_string (surface.components[0].genus) +
                            (surface.components[0].orientable ? "" : " (not orientable)") + ", " +
                            grouped (surface.boundary_loops) + " boundary loops"
                        : grouped (surface.components.size ()) + " components"));
  else if (status_ == Status::DIMENSION_TOO_LOW)
    lines.push_back (mesh + "no face");
  else
    lines.push_back (std::string ("failed: ") + toString (status_));
  return lines;
}

pcl::PolygonMesh
GraphViewerModel::mesh () const
{
  pcl::PolygonMesh mesh;
  mesh.cloud = cloud_;
  mesh.polygons = polygonsOf (result_, graph_.input_index);
  return mesh;
}

} // namespace pcl::manifold::apps
