#include "graph_viewer_window.h"

#include "app_files.h"
#include "interrupt.h"
#include "offscreen_window.h"
#include "picture.h"
#include "view.h"
#include "window_png.h"

#include <pcl/manifold/complex_io.h>

#include <vtkCamera.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>

#include <algorithm>
#include <future>

namespace pcl::manifold::apps {
namespace {

constexpr int WIDTH = 1200;
constexpr int HEIGHT = 900;
constexpr int MARGIN = 16;
constexpr int FONT_SIZE = 16;
constexpr int LINE_HEIGHT = 24;
constexpr int LONGEST_WAIT = 50; // milliseconds until the window looks for events again
constexpr Colour TEXT_COLOUR{0.1, 0.1, 0.1};
constexpr Colour MESSAGE_COLOUR{0.0, 0.35, 0.65};

vtkRenderer&
rendererOf (pcl::visualization::PCLVisualizer& visualizer)
{
  return *visualizer.getRendererCollection ()->GetFirstRenderer ();
}

} // namespace

GraphViewerWindow::GraphViewerWindow (GraphViewerModel& model, const std::string& title,
                                      const Outputs& outputs, bool interactive)
  : model_ (model), title_ (title), outputs_ (outputs),
    visualizer_ (vtkSmartPointer<vtkRenderer>::New (),
                 interactive ? vtkSmartPointer<vtkRenderWindow>::New () : makeOffscreenWindow (), title,
                 interactive)
{
  visualizer_.setShowFPS (false);
  visualizer_.setBackgroundColor (1, 1, 1);
  visualizer_.setSize (WIDTH, HEIGHT);
  frame_ = frameOf (cornersOf (model_.panels ()));
  resetCamera ();
  draw ();
}

void
GraphViewerWindow::resetCamera ()
{
  std::vector<std::array<double, 3>> corners = cornersOf (model_.panels ());
  for (std::array<double, 3>& corner : corners)
    corner = frame_ (corner);
  const View view = chooseView (corners, static_cast<double> (WIDTH) / HEIGHT);
  constexpr double DISTANCE = 10.0; // far outside of the cube that the scene is scaled to
  constexpr double ROOM_FOR_TEXTS = 1.35;
  std::array<double, 3> eye{};
  for (std::size_t axis = 0; axis < 3; ++axis)
    eye[axis] = view.centre[axis] - DISTANCE * view.towards[axis];
  vtkCamera& camera = *rendererOf (visualizer_).GetActiveCamera ();
  camera.ParallelProjectionOn ();
  camera.SetFocalPoint (view.centre.data ());
  camera.SetPosition (eye.data ());
  camera.SetViewUp (view.up.data ());
  camera.SetParallelScale (view.half_height * ROOM_FOR_TEXTS);
}

void
GraphViewerWindow::draw ()
{
  vtkRenderer& renderer = rendererOf (visualizer_);
  for (const auto& actor : actors_)
    renderer.RemoveActor (actor);
  actors_.clear ();
  const std::vector<Layer> layers = model_.layers ();
  for (const Layer& layer : layers) {
    // Points are sized for the panels of pictures, which are smaller.
    constexpr double POINT_SCALE = 2.0;
    actors_.push_back (makeActor (layer, frame_, layer.kind == Layer::Kind::POINTS ? POINT_SCALE : 1.0));
    renderer.AddActor (actors_.back ());
  }
  drawTexts (layers);
  renderer.ResetCameraClippingRange ();
}

void
GraphViewerWindow::drawTexts (const std::vector<Layer>& layers)
{
  visualizer_.removeAllShapes ();
  int number = 0;
  const auto write = [&] (const std::string& text, int x, int y, const Colour& colour, int size = FONT_SIZE) {
    visualizer_.addText (text, x, y, size, colour[0], colour[1], colour[2],
                         "text " + std::to_string (number++));
  };
  int y = HEIGHT - MARGIN - LINE_HEIGHT;
  write (title_ + "   " + model_.caption (), MARGIN, y, TEXT_COLOUR, FONT_SIZE + 4);
  for (const std::string& line : model_.description ())
    write (line, MARGIN, y -= LINE_HEIGHT, TEXT_COLOUR);
  if (!message_.empty ())
    write (message_, MARGIN, y - LINE_HEIGHT, MESSAGE_COLOUR);

  y = MARGIN;
  for (auto layer = layers.rbegin (); layer != layers.rend (); ++layer)
    if (!layer->name.empty ()) {
      write (layer->name, MARGIN, y, layer->colour);
      y += LINE_HEIGHT;
    }
  constexpr int HELP_WIDTH = 330;
  constexpr int HELP_KEYS_WIDTH = 80;
  constexpr int HELP_SIZE = 13;
  constexpr int HELP_STEP = 19;
  y = MARGIN;
  const std::vector<std::string>& help = GraphViewerModel::help ();
  for (auto line = help.rbegin (); line != help.rend (); ++line, y += HELP_STEP) {
    const std::size_t gap = line->find ("  ");
    write (line->substr (0, gap), WIDTH - HELP_WIDTH, y, TEXT_COLOUR, HELP_SIZE);
    write (line->substr (line->find_first_not_of (' ', gap)), WIDTH - HELP_WIDTH + HELP_KEYS_WIDTH, y,
           TEXT_COLOUR, HELP_SIZE);
  }
}

void
GraphViewerWindow::press (const std::string& key)
{
  const GraphViewerModel::Action action = model_.press (key);
  if (action == GraphViewerModel::Action::NOTHING)
    return;
  message_.clear ();
  if (action == GraphViewerModel::Action::SAVE_MESH) {
    std::string error;
    if (!savePolygonMesh (outputs_.mesh, model_.mesh (), error))
      throw AppError (outputs_.mesh, error);
    message_ = outputs_.mesh + " saved";
  } else if (action == GraphViewerModel::Action::SAVE_PICTURE) {
    // In a thread of its own: OpenGL of a window on the screen is current in this one.
    std::async (std::launch::async, [this] {
      writePicture (outputs_.picture, title_, model_.panels (), 1600, 1200);
    }).get ();
    message_ = outputs_.picture + " saved";
  }
  draw ();
}

void
GraphViewerWindow::run ()
{
  visualizer_.registerKeyboardCallback ([this] (const pcl::visualization::KeyboardEvent& event) {
    if (!event.keyDown ())
      return;
    try {
      press (event.getKeySym ());
    } catch (const AppError& error) {
      message_ = error.what ();
      draw ();
    }
  });
  while (!visualizer_.wasStopped ()) {
    visualizer_.spinOnce (LONGEST_WAIT, true);
    throwIfInterrupted (title_);
  }
}

void
GraphViewerWindow::saveScreenshot (const std::string& file)
{
  vtkRenderWindow& window = *visualizer_.getRenderWindow ();
  window.Render ();
  // PCLVisualizer's own saveScreenshot () needs the interactor that only a window on the screen has.
  const std::string png = windowPng (window, 1);
  if (png.empty ())
    throw AppError (file, "the picture could not be drawn");
  writeFile (file, png);
}

} // namespace pcl::manifold::apps
