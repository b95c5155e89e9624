#include "layer_actor.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>

#include <algorithm>
#include <cmath>

namespace pcl::manifold::apps {
namespace {

bool
isFinite (const std::array<float, 3>& position)
{
  return std::isfinite (position[0]) && std::isfinite (position[1]) && std::isfinite (position[2]);
}

vtkSmartPointer<vtkPolyData>
makeData (const Layer& layer, const UnitFrame& frame)
{
  const vtkNew<vtkPoints> points;
  const vtkNew<vtkCellArray> cells;
  const auto corners_per_cell = static_cast<std::size_t> (layer.kind);
  std::vector<vtkIdType> ids (layer.positions->size (), -1);
  std::vector<vtkIdType> cell (corners_per_cell);
  for (std::size_t begin = 0; begin + corners_per_cell <= layer.corners.size (); begin += corners_per_cell) {
    bool finite = true;
    for (std::size_t i = 0; i < corners_per_cell; ++i) {
      const auto corner = static_cast<std::size_t> (layer.corners[begin + i]);
      const std::array<float, 3>& position = layer.positions->at (corner);
      finite = finite && isFinite (position);
      if (finite && ids[corner] < 0)
        ids[corner] = points->InsertNextPoint (frame (position).data ());
      cell[i] = ids[corner];
    }
    if (finite)
      cells->InsertNextCell (static_cast<vtkIdType> (corners_per_cell), cell.data ());
  }
  auto data = vtkSmartPointer<vtkPolyData>::New ();
  data->SetPoints (points);
  switch (layer.kind) {
    case Layer::Kind::POINTS:
      data->SetVerts (cells);
      break;
    case Layer::Kind::LINES:
      data->SetLines (cells);
      break;
    case Layer::Kind::TRIANGLES:
      data->SetPolys (cells);
      break;
  }
  return data;
}

void
shadeTriangles (vtkActor& actor, const Layer& layer)
{
  vtkProperty& property = *actor.GetProperty ();
  property.SetAmbient (0.3);
  property.SetDiffuse (0.75);
  if (!layer.smooth)
    property.SetInterpolationToFlat ();
  // Where a triangle is seen from behind it shows: a pale red for every colour.
  const vtkNew<vtkProperty> back;
  back->DeepCopy (&property);
  back->SetColor (0.85, 0.55, 0.55);
  actor.SetBackfaceProperty (back);
}

} // namespace

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

vtkSmartPointer<vtkActor>
makeActor (const Layer& layer, const UnitFrame& frame, double pixel_scale)
{
  const vtkNew<vtkPolyDataMapper> mapper;
  const vtkSmartPointer<vtkPolyData> data = makeData (layer, frame);
  if (layer.kind == Layer::Kind::TRIANGLES && layer.smooth) {
    const vtkNew<vtkPolyDataNormals> normals;
    normals->SetInputData (data);
    normals->SplittingOff ();
    normals->ConsistencyOff ();
    normals->Update ();
    mapper->SetInputData (normals->GetOutput ());
  } else
    mapper->SetInputData (data);
  mapper->ScalarVisibilityOff ();
  auto actor = vtkSmartPointer<vtkActor>::New ();
  actor->SetMapper (mapper);
  vtkProperty& property = *actor->GetProperty ();
  property.SetColor (layer.colour[0], layer.colour[1], layer.colour[2]);
  if (layer.kind == Layer::Kind::TRIANGLES) {
    shadeTriangles (*actor, layer);
    return actor;
  }
  const bool points = layer.kind == Layer::Kind::POINTS;
  constexpr double line_width = 2.5;
  const double size = layer.size > 0 ? layer.size : points ? pointSize (layer.corners.size ()) : line_width;
  if (points) {
    property.SetPointSize (static_cast<float> (size * pixel_scale));
    property.RenderPointsAsSpheresOn ();
    property.SetAmbient (0.4);
    property.SetDiffuse (0.7);
  } else {
    property.LightingOff ();
    property.SetLineWidth (static_cast<float> (size * pixel_scale));
  }
  return actor;
}

} // namespace pcl::manifold::apps
