#pragma once

#include "cloud_reader.h"
#include "graph_layers.h"
#include "scene.h"

#include <pcl/PolygonMesh.h>
#include <pcl/manifold/cloud_graph.h>
#include <pcl/manifold/reconstruct_graph.h>

#include <memory>
#include <string>
#include <vector>

namespace pcl::manifold::apps {

/** \brief What the viewer of GraphReconstruction shows, and what its keys change: everything but the window.
 */
class GraphViewerModel
{
public:
  /** \brief What is shown: the panels of figure 1 of the paper. */
  enum class View
  {
    CLOUD,
    TILES,
    ADJACENCIES,
    FACES
  };

  /** \brief What the window has to do once a key was pressed. */
  enum class Action
  {
    NOTHING, ///< the key means nothing, or changed nothing
    REDRAW,
    SAVE_MESH,
    SAVE_PICTURE
  };

  /** \brief Computes everything, and shows the cloud.
   * \param[in] input the cloud
   * \param[in] parameters to begin with */
  GraphViewerModel (const InputCloud& input, const GraphParameters& parameters);

  /** \brief Does what a key stands for, see help (); computes again what that changes.
   * \param[in] key as VTK names it: "k", "K", "Right" */
  Action press (const std::string& key);

  /** \brief Whether a key stands for anything, r and q for what the window does among them. */
  static bool knows (const std::string& key);

  View view () const { return view_; }

  const GraphParameters& parameters () const { return parameters_; }

  /** \brief How the last computation ended. */
  Status status () const { return status_; }

  std::size_t landmarks () const { return result_.landmarks.size (); }

  const pcl::TopologyReport& report () const { return result_.report; }

  /** \brief What to draw. Of what could not be computed, nothing. */
  std::vector<Layer> layers () const;

  /** \brief All four views. */
  std::vector<Panel> panels () const;

  /** \brief The name of the view. */
  std::string caption () const;

  /** \brief Parameters, counts, and how long the stages took. */
  std::vector<std::string> description () const;

  /** \brief The keys and their meaning. */
  static const std::vector<std::string>& help ();

  /** \brief The mesh over all points of the cloud; no polygons where there is no face. */
  pcl::PolygonMesh mesh () const;

private:
  /** \brief Changes a parameter, within limits. */
  Action change (int& parameter, int step, int low, int high, bool graph_too);

  Action show (int step);

  void computeGraph ();

  void computeMesh ();

  GraphStages stages () const;

  pcl::PCLPointCloud2 cloud_;
  std::shared_ptr<const Positions> positions_;
  GraphParameters parameters_;
  View view_ = View::CLOUD;
  CloudGraph graph_;
  Status graph_status_ = Status::NOT_COMPUTED;
  std::vector<Stage> graph_stages_;
  GraphMesh result_;
  Status status_ = Status::NOT_COMPUTED;
  std::vector<Stage> mesh_stages_;
  std::vector<pcl::index_t> tiles_; ///< per point of the cloud
  pcl::Indices landmarks_;          ///< points of the cloud
};

} // namespace pcl::manifold::apps
