#include "panel_texts.h"

#include <vtkActor2D.h>
#include <vtkCellArray.h>
#include <vtkCoordinate.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtk_utf8.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace pcl::manifold::apps {
namespace {

constexpr double legend_margin = 16;
constexpr double legend_step = 26;

/** \brief VTK draws nothing of a text that is not valid UTF-8, such as the names of some files. */
std::string
validText (const std::string& text)
{
  std::string valid;
  utf8::replace_invalid (text.begin (), text.end (), std::back_inserter (valid), '?');
  return valid;
}

/** \brief Fills a square, whose lower left corner is given in pixels of the viewport. */
void
addSwatch (vtkRenderer& renderer, double x, double y, double size, const Colour& colour)
{
  const vtkNew<vtkPoints> points;
  for (const auto& [right, up] : {std::pair (0, 0), std::pair (1, 0), std::pair (1, 1), std::pair (0, 1)})
    points->InsertNextPoint ((x + right * size) * oversampling, (y + up * size) * oversampling, 0);
  const vtkNew<vtkCellArray> cells;
  cells->InsertNextCell ({0, 1, 2, 3});
  const vtkNew<vtkPolyData> square;
  square->SetPoints (points);
  square->SetPolys (cells);
  const vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData (square);
  const vtkNew<vtkActor2D> actor;
  actor->SetMapper (mapper);
  actor->GetProperty ()->SetColor (colour[0], colour[1], colour[2]);
  renderer.AddActor2D (actor);
}

} // namespace

void
addText (vtkRenderer& renderer, const std::string& text, double x, double y, int size, bool bold)
{
  const vtkNew<vtkTextActor> actor;
  actor->SetInput (validText (text).c_str ());
  actor->GetPositionCoordinate ()->SetCoordinateSystemToViewport ();
  actor->SetPosition (x * oversampling, y * oversampling);
  vtkTextProperty& property = *actor->GetTextProperty ();
  property.SetFontFamilyToArial ();
  property.SetFontSize (size * oversampling);
  property.SetColor (0.1, 0.1, 0.1);
  property.SetBold (bold);
  renderer.AddActor2D (actor);
}

double
legendHeight (const std::vector<Layer>& layers)
{
  return legend_margin + legend_step * static_cast<double> (std::count_if (
                                         layers.begin (), layers.end (),
                                         [] (const Layer& layer) { return !layer.name.empty (); }));
}

void
addLegend (vtkRenderer& renderer, const std::vector<Layer>& layers)
{
  double y = legend_margin;
  for (auto layer = layers.rbegin (); layer != layers.rend (); ++layer)
    if (!layer->name.empty ()) {
      addSwatch (renderer, 20, y, 16, layer->colour);
      addText (renderer, layer->name, 46, y, 18, false);
      y += legend_step;
    }
}

} // namespace pcl::manifold::apps
