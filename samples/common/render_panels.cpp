#include "render_panels.h"

#include "layer_actor.h"
#include "panel_texts.h"
#include "view.h"

#include <vtkCamera.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkImageShrink3D.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkPNGWriter.h>
#include <vtkPointData.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>

namespace pcl::manifold::apps {
namespace {

UnitFrame
frameOf (const std::vector<std::array<double, 3>>& corners)
{
  UnitFrame frame;
  double extent = 0;
  for (int axis = 0; axis < 3 && !corners.empty (); ++axis) {
    const auto [low, high] = std::minmax_element (
      corners.begin (), corners.end (), [axis] (const auto& a, const auto& b) { return a[axis] < b[axis]; });
    frame.centre[axis] = ((*low)[axis] + (*high)[axis]) / 2;
    extent = std::max (extent, (*high)[axis] - (*low)[axis]);
  }
  if (extent > 0)
    frame.scale = extent / 2;
  return frame;
}

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

/** \brief The window as it was drawn, shrunk to its true size, as the bytes of a PNG file. */
std::string
pngOf (vtkRenderWindow& window)
{
  const vtkNew<vtkWindowToImageFilter> grabber;
  grabber->SetInput (&window);
  grabber->SetInputBufferTypeToRGB ();
  grabber->ReadFrontBufferOff ();
  grabber->ShouldRerenderOff ();
  const vtkNew<vtkImageShrink3D> shrinker;
  shrinker->SetInputConnection (grabber->GetOutputPort ());
  shrinker->SetShrinkFactors (oversampling, oversampling, 1);
  shrinker->MeanOn ();
  shrinker->Update ();
  double range[2] = {0, 0};
  vtkImageData& image = *shrinker->GetOutput ();
  if (image.GetNumberOfPoints () == 0)
    return {};
  image.GetPointData ()->GetScalars ()->GetRange (range, -1);
  const vtkNew<vtkPNGWriter> writer;
  writer->SetInputData (&image);
  writer->WriteToMemoryOn ();
  writer->Write ();
  vtkUnsignedCharArray* const bytes = writer->GetResult ();
  // An OpenGL that does not work leaves one colour.
  if (bytes == nullptr || range[0] == range[1])
    return {};
  return {reinterpret_cast<const char*> (bytes->GetPointer (0)),
          static_cast<std::size_t> (bytes->GetNumberOfValues ())};
}

} // namespace

std::string
renderPanels (const std::string& title, const std::vector<Panel>& panels, int width, int height)
{
  vtkObject::GlobalWarningDisplayOff ();
  std::vector<std::array<double, 3>> corners = cornersOf (panels);
  const UnitFrame frame = frameOf (corners);
  for (std::array<double, 3>& corner : corners)
    corner = frame (corner);
  const auto count = static_cast<double> (panels.size ());
  const double panel_height = height - title_height;
  double bottom = 0;
  for (const Panel& panel : panels)
    bottom = std::max (bottom, legendHeight (panel.layers));
  const double top = std::max (bottom + 1, panel_height - caption_height);
  const View view = chooseView (corners, width / count / (top - bottom));

  const vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering (1);
  window->SetMultiSamples (0);
  window->SetSize (width * oversampling, height * oversampling);
  const vtkNew<vtkRenderer> heading;
  heading->SetViewport (0, panel_height / height, 1, 1);
  heading->SetBackground (1, 1, 1);
  addText (*heading, title, 20, 14, 26, true);
  window->AddRenderer (heading);
  for (std::size_t i = 0; i < panels.size (); ++i) {
    const vtkNew<vtkRenderer> renderer;
    renderer->SetViewport (static_cast<double> (i) / count, 0, static_cast<double> (i + 1) / count,
                           panel_height / height);
    renderer->SetBackground (1, 1, 1);
    for (const Layer& layer : panels[i].layers)
      renderer->AddActor (makeActor (layer, frame, oversampling));
    addText (*renderer, panels[i].caption, 20, panel_height - 30, 20, false);
    addLegend (*renderer, panels[i].layers);
    place (*renderer, view, panel_height, bottom, top);
    window->AddRenderer (renderer);
  }
  window->Render ();
  return pngOf (*window);
}

} // namespace pcl::manifold::apps
