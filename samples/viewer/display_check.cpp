#include "display_check.h"

#include <GL/glx.h>

// In a file of its own: X defines Status, None and Success as macros.
bool
pcl::manifold::apps::canOpenWindow ()
{
  Display* const display = XOpenDisplay (nullptr);
  if (display == nullptr)
    return false;
  const bool has_opengl = glXQueryExtension (display, nullptr, nullptr) == True;
  XCloseDisplay (display);
  return has_opengl;
}
