#pragma once

#include <string>

class vtkRenderWindow;

namespace pcl::manifold::apps {

/** \brief What was last drawn in a window, as the bytes of a PNG file; empty if that was one colour, as an
 * OpenGL that does not work leaves it.
 * \param[in] shrink the picture is that many times smaller than the window */
std::string windowPng (vtkRenderWindow& window, int shrink);

} // namespace pcl::manifold::apps
