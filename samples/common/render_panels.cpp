#include "render_panels.h"

#include "layer_actor.h"
#include "offscreen_window.h"
#include "panel_texts.h"
#include "view.h"
#include "window_png.h"

#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include <algorithm>

namespace pcl::manifold::apps {
namespace {

constexpr double caption_height = 48;
constexpr double title_height = 56;

/** \brief Points the camera so that the view fills a panel between `bottom` and `top`, in pixels. */
void
place (vtkRenderer& renderer, const View& view, double panel_height, double bottom, double top)
{
  constexpr double distance = 10; // far outside of the cube that the scene was scaled to
  const double pixel = 2 * view.half_height / (top - bottom);
  const double shift = (panel_height - bottom - top) / 2 * pixel;
  std::array<double, 3> centre{};
  std::array<double, 3> eye{};
  for (int axis = 0; axis < 3; ++axis) {
    centre[axis] = view.centre[axis] + shift * view.up[axis];
    eye[axis] = centre[axis] - distance * view.towards[axis];
  }
  vtkCamera& camera = *renderer.GetActiveCamera ();
  camera.ParallelProjectionOn ();
  camera.SetFocalPoint (centre.data ());
  camera.SetPosition (eye.data ());
  camera.SetViewUp (view.up.data ());
  camera.SetParallelScale (panel_height / 2 * pixel);
  camera.SetClippingRange (distance - 4, distance + 4);
}

} // namespace

std::string
renderPanels (const std::string& title, const std::vector<Panel>& panels, int width, int height)
{
  std::vector<std::array<double, 3>> corners = cornersOf (panels);
  const UnitFrame frame = frameOf (corners);
  for (std::array<double, 3>& corner : corners)
    corner = frame (corner);
  // More than three panels would be too narrow side by side.
  const std::size_t rows = panels.size () > 3 ? 2 : 1;
  const std::size_t columns = (panels.size () + rows - 1) / rows;
  const double all_height = height - title_height;
  const double panel_height = all_height / static_cast<double> (rows);
  double bottom = 0;
  for (const Panel& panel : panels)
    bottom = std::max (bottom, legendHeight (panel.layers));
  const double top = std::max (bottom + 1, panel_height - caption_height);
  const View view = chooseView (corners, width / static_cast<double> (columns) / (top - bottom));

  const vtkSmartPointer<vtkRenderWindow> window = makeOffscreenWindow ();
  window->SetMultiSamples (0);
  window->SetSize (width * oversampling, height * oversampling);
  const vtkNew<vtkRenderer> heading;
  heading->SetViewport (0, all_height / height, 1, 1);
  heading->SetBackground (1, 1, 1);
  addText (*heading, title, 20, 14, 26, true);
  window->AddRenderer (heading);
  for (std::size_t i = 0; i < panels.size (); ++i) {
    const vtkNew<vtkRenderer> renderer;
    const auto column = static_cast<double> (i % columns);
    const auto row_from_below = static_cast<double> (rows - 1 - i / columns);
    renderer->SetViewport (column / static_cast<double> (columns), row_from_below * panel_height / height,
                           (column + 1) / static_cast<double> (columns),
                           (row_from_below + 1) * panel_height / height);
    renderer->SetBackground (1, 1, 1);
    for (const Layer& layer : panels[i].layers)
      renderer->AddActor (makeActor (layer, frame, oversampling));
    addText (*renderer, panels[i].caption, 20, panel_height - 30, 20, false);
    addLegend (*renderer, panels[i].layers);
    place (*renderer, view, panel_height, bottom, top);
    window->AddRenderer (renderer);
  }
  window->Render ();
  return windowPng (*window, oversampling);
}

} // namespace pcl::manifold::apps
