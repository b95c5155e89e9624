#pragma once

#include <vtkRenderWindow.h>
#include <vtkSmartPointer.h>

namespace pcl::manifold::apps {

/** \brief A window to draw in that nobody sees. It needs no display: OpenGL comes from EGL, and the processor
 * draws, so a picture is the same on every machine. To be used in the thread that made it, where no window on
 * a screen may be current.
 * \throws std::runtime_error that says what to install where there is no such OpenGL */
vtkSmartPointer<vtkRenderWindow> makeOffscreenWindow ();

} // namespace pcl::manifold::apps
