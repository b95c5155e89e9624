#pragma once

#include "scene.h"

#include <pcl/manifold/graph_faces.h>
#include <pcl/types.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace pcl::manifold::apps {

/** \brief What the stages of GraphReconstruction gave, to be drawn: references to what must stay. */
struct GraphStages
{
  std::shared_ptr<const Positions> positions; ///< of the points of the cloud
  const std::vector<pcl::index_t>& tiles;     ///< per point of the cloud the number of its landmark, or -1
  const pcl::Indices& landmarks;              ///< points of the cloud
  const std::vector<TileContact>& contacts;   ///< by numbers of landmarks
  const LandmarkMesh& mesh;                   ///< likewise
};

/** \brief A number per tile, such that tiles that touch have different ones as far as `colours` numbers are
 * enough: each tile in turn takes one that fewest of its neighbours have, the one used least of those. */
std::vector<std::size_t> colourTiles (std::size_t tiles, const std::vector<TileContact>& contacts,
                                      std::size_t colours);

// The four panels of figure 1 of the paper.

std::vector<Layer> cloudLayers (const GraphStages& stages);

/** \brief The points, each tile in a colour of its own. */
std::vector<Layer> tileLayers (const GraphStages& stages);

/** \brief Landmarks and the edges between those that are adjacent. */
std::vector<Layer> adjacencyLayers (const GraphStages& stages);

/** \brief Triangles, larger faces lighter, edges in no face thick and red. */
std::vector<Layer> faceLayers (const GraphStages& stages);

/** \brief All four, with captions. */
std::vector<Panel> graphPanels (const GraphStages& stages);

} // namespace pcl::manifold::apps
