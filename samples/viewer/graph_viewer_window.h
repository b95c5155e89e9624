#pragma once

#include "graph_viewer_model.h"
#include "layer_actor.h"

#include <pcl/visualization/pcl_visualizer.h>

#include <string>

namespace pcl::manifold::apps {

/** \brief The window of pcl_graph_reconstruction_viewer. */
class GraphViewerWindow
{
public:
  /** \brief Where the keys F2 and F3 save to. */
  struct Outputs
  {
    std::string mesh;
    std::string picture;
  };

  /** \param[in] model outlives the window
   * \param[in] title of the window
   * \param[in] outputs names of the files
   * \param[in] interactive false to draw without a window on the screen; true needs canOpenWindow ()
   * \throws std::runtime_error if there is no OpenGL to draw with (see makeOffscreenWindow ()) */
  GraphViewerWindow (GraphViewerModel& model, const std::string& title, const Outputs& outputs,
                     bool interactive);

  GraphViewerWindow (const GraphViewerWindow&) = delete;
  GraphViewerWindow& operator= (const GraphViewerWindow&) = delete;

  /** \brief Does what a key asks for, see GraphViewerModel::help ().
   * \throws AppError if a file cannot be saved */
  void press (const std::string& key);

  /** \brief Shows the window until the user closes it. A file that cannot be saved is told of in the window.
   * \throws AppError if the user pressed Ctrl-C */
  void run ();

  /** \brief Writes what the window shows as a PNG file, atomically.
   * \throws AppError if that fails */
  void saveScreenshot (const std::string& file);

private:
  void draw ();

  void drawTexts (const std::vector<Layer>& layers);

  void resetCamera ();

  GraphViewerModel& model_;
  std::string title_;
  Outputs outputs_;
  UnitFrame frame_;
  std::string message_; ///< what was saved, or why not
  pcl::visualization::PCLVisualizer visualizer_;
  std::vector<vtkSmartPointer<vtkActor>> actors_;
};

} // namespace pcl::manifold::apps
