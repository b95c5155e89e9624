#include "window_png.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkImageShrink3D.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPointData.h>
#include <vtkRenderWindow.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

#include <cstddef>

namespace pcl::manifold::apps {

std::string
windowPng (vtkRenderWindow& window, int shrink)
{
  const vtkNew<vtkWindowToImageFilter> grabber;
  grabber->SetInput (&window);
  grabber->SetInputBufferTypeToRGB ();
  grabber->ReadFrontBufferOff ();
  grabber->ShouldRerenderOff ();
  const vtkNew<vtkImageShrink3D> shrinker;
  shrinker->SetInputConnection (grabber->GetOutputPort ());
  shrinker->SetShrinkFactors (shrink, shrink, 1);
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

} // namespace pcl::manifold::apps
