#include "graph_layers.h"

#include "table.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <set>
#include <utility>

namespace pcl::manifold::apps {
namespace {

/** \brief Twelve colours that are easily told apart side by side. */
constexpr std::array<Colour, 12> TILE_COLOURS = {{
  {0.12, 0.47, 0.71},
  {1.00, 0.50, 0.05},
  {0.17, 0.63, 0.17},
  {0.84, 0.15, 0.16},
  {0.58, 0.40, 0.74},
  {0.55, 0.34, 0.29},
  {0.89, 0.47, 0.76},
  {0.74, 0.74, 0.13},
  {0.09, 0.75, 0.81},
  {0.60, 0.87, 0.54},
  {1.00, 0.73, 0.47},
  {0.35, 0.35, 0.35},
}};

constexpr Colour GREY{0.55, 0.55, 0.55};
constexpr Colour BLACK{0.10, 0.10, 0.10};
constexpr Colour RED{0.85, 0.05, 0.05};
constexpr Colour TRIANGLE_BLUE{0.20, 0.48, 0.80};
constexpr Colour LARGER_FACE_BLUE{0.68, 0.84, 0.98};

/** \brief "1 tile", "2 tiles". */
std::string
text (std::size_t count, const std::string& one, const std::string& many)
{
  return grouped (count) + " " + (count == 1 ? one : many);
}

Layer
layerOf (Layer::Kind kind, const GraphStages& stages, const Colour& colour)
{
  Layer layer;
  layer.kind = kind;
  layer.positions = stages.positions;
  layer.colour = colour;
  return layer;
}

/** \brief Adds a line or triangle between landmarks. */
template <typename Corners>
void
add (const Corners& corners, const GraphStages& stages, Layer& layer)
{
  for (const pcl::index_t landmark : corners)
    layer.corners.push_back (stages.landmarks[landmark]);
}

/** \brief Adds the faces of three edges, or those of more, cut into triangles. */
void
addFaces (const GraphStages& stages, bool larger, std::vector<Layer>& layers)
{
  LandmarkMesh part;
  part.edges = stages.mesh.edges;
  std::copy_if (stages.mesh.faces.begin (), stages.mesh.faces.end (), std::back_inserter (part.faces),
                [larger] (const auto& face) { return (face.size () > 3) == larger; });
  Eigen::MatrixXd points (3, static_cast<Eigen::Index> (stages.landmarks.size ()));
  for (std::size_t i = 0; i < stages.landmarks.size (); ++i)
    for (std::size_t axis = 0; axis < 3; ++axis)
      points (static_cast<Eigen::Index> (axis), static_cast<Eigen::Index> (i)) =
        (*stages.positions)[stages.landmarks[i]][axis];
  Layer layer = layerOf (Layer::Kind::TRIANGLES, stages, larger ? LARGER_FACE_BLUE : TRIANGLE_BLUE);
  layer.name =
    text (part.faces.size (), larger ? "larger face" : "triangle", larger ? "larger faces" : "triangles");
  for (const auto& triangle : triangulateFaces (part, points))
    add (triangle, stages, layer);
  if (!part.faces.empty ())
    layers.push_back (std::move (layer));
}

} // namespace

std::vector<std::size_t>
colourTiles (std::size_t tiles, const std::vector<TileContact>& contacts, std::size_t colours)
{
  std::vector<std::vector<std::size_t>> smaller (tiles);
  for (const TileContact& contact : contacts)
    smaller[static_cast<std::size_t> (contact.second)].push_back (static_cast<std::size_t> (contact.first));
  std::vector<std::size_t> colour_of (tiles);
  std::vector<std::size_t> used (colours, 0);
  for (std::size_t tile = 0; tile < tiles; ++tile) {
    std::vector<std::size_t> near (colours, 0);
    for (const std::size_t other : smaller[tile])
      ++near[colour_of[other]];
    std::size_t best = 0;
    for (std::size_t colour = 1; colour < colours; ++colour)
      if (std::pair (near[colour], used[colour]) < std::pair (near[best], used[best]))
        best = colour;
    colour_of[tile] = best;
    ++used[best];
  }
  return colour_of;
}

std::vector<Layer>
cloudLayers (const GraphStages& stages)
{
  Layer points = layerOf (Layer::Kind::POINTS, stages, GREY);
  for (std::size_t i = 0; i < stages.positions->size (); ++i)
    points.corners.push_back (static_cast<std::int32_t> (i));
  points.name = text (points.corners.size (), "point", "points");
  return {points};
}

std::vector<Layer>
tileLayers (const GraphStages& stages)
{
  const std::vector<std::size_t> colours =
    colourTiles (stages.landmarks.size (), stages.contacts, TILE_COLOURS.size ());
  std::vector<Layer> layers;
  for (const Colour& colour : TILE_COLOURS)
    layers.push_back (layerOf (Layer::Kind::POINTS, stages, colour));
  for (std::size_t i = 0; i < stages.tiles.size (); ++i)
    if (stages.tiles[i] >= 0)
      layers[colours[stages.tiles[i]]].corners.push_back (static_cast<std::int32_t> (i));
  // Points are drawn smaller the more there are; all tiles alike.
  const double size = pointSize (stages.tiles.size ());
  for (Layer& layer : layers)
    layer.size = size;
  layers.erase (std::remove_if (layers.begin (), layers.end (),
                                [] (const Layer& layer) { return layer.corners.empty (); }),
                layers.end ());
  if (!layers.empty ())
    layers.front ().name = text (stages.landmarks.size (), "tile", "tiles");
  return layers;
}

std::vector<Layer>
adjacencyLayers (const GraphStages& stages)
{
  Layer edges = layerOf (Layer::Kind::LINES, stages, TRIANGLE_BLUE);
  for (const LandmarkMesh::Edge& edge : stages.mesh.edges)
    add (edge, stages, edges);
  edges.name = text (stages.mesh.edges.size (), "adjacency", "adjacencies");
  constexpr std::size_t MANY_EDGES = 5000;
  edges.size = stages.mesh.edges.size () > MANY_EDGES ? 1.0 : 1.5;
  Layer points = layerOf (Layer::Kind::POINTS, stages, BLACK);
  points.corners.assign (stages.landmarks.begin (), stages.landmarks.end ());
  points.name = text (stages.landmarks.size (), "landmark", "landmarks");
  return {edges, points};
}

std::vector<Layer>
faceLayers (const GraphStages& stages)
{
  std::vector<Layer> layers;
  addFaces (stages, false, layers);
  addFaces (stages, true, layers);
  std::set<LandmarkMesh::Edge> free (stages.mesh.edges.begin (), stages.mesh.edges.end ());
  for (const std::vector<pcl::index_t>& face : stages.mesh.faces)
    for (std::size_t i = 0; i < face.size (); ++i) {
      const auto [low, high] = std::minmax (face[i], face[(i + 1) % face.size ()]);
      free.erase ({low, high});
    }
  if (!free.empty ()) {
    Layer lines = layerOf (Layer::Kind::LINES, stages, RED);
    lines.size = 6;
    for (const LandmarkMesh::Edge& edge : free)
      add (edge, stages, lines);
    lines.name = text (free.size (), "edge in no face", "edges in no face");
    layers.push_back (lines);
  }
  return layers;
}

std::vector<Panel>
graphPanels (const GraphStages& stages)
{
  return {{"point cloud", cloudLayers (stages)},
          {"graph Voronoi diagram", tileLayers (stages)},
          {"adjacencies", adjacencyLayers (stages)},
          {"faces", faceLayers (stages)}};
}

} // namespace pcl::manifold::apps
