#include "picture_display.h"

#include "child_process.h"
#include "virtual_display.h"

#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <csignal>
#include <cstdlib>
#include <stdexcept>

#include <sys/wait.h>
#include <unistd.h>

namespace pcl::manifold::apps {
namespace {

using namespace std::chrono_literals;

/** \brief Draws an empty window; VTK aborts if it cannot. */
void
drawNothing ()
{
  const vtkNew<vtkRenderWindow> window;
  const vtkNew<vtkRenderer> renderer;
  window->SetOffScreenRendering (1);
  window->SetSize (16, 16);
  window->AddRenderer (renderer);
  window->Render ();
}

/** \brief Can VTK draw on the display that DISPLAY names? */
bool
canDraw ()
{
  const pid_t parent = getpid ();
  const pid_t child = fork ();
  if (child == 0) {
    becomeQuietChild (parent);
    drawNothing ();
    _exit (0);
  }
  int status = 1;
  if (child < 0)
    return false;
  if (!waitFor (child, 30s, status)) {
    kill (child, SIGKILL);
    waitFor (child, 3s, status);
    return false;
  }
  return WIFEXITED (status) && WEXITSTATUS (status) == 0;
}

} // namespace

// The environment is changed by the main thread, before others work and after they are done.
// NOLINTBEGIN(concurrency-mt-unsafe)
PictureDisplay::PictureDisplay ()
{
  const char* const display = std::getenv ("DISPLAY");
  had_display_ = display != nullptr;
  old_display_ = had_display_ ? display : "";
  if (!old_display_.empty () && canDraw ())
    return;
  try {
    virtual_display_ = std::make_unique<VirtualDisplay> ();
  } catch (const std::runtime_error& error) {
    throw std::runtime_error (std::string ("a picture needs a display: set DISPLAY or install xvfb (") +
                              error.what () + ")");
  }
  setenv ("DISPLAY", virtual_display_->name ().c_str (), 1);
  if (canDraw ())
    return;
  restore ();
  throw std::runtime_error ("a picture needs OpenGL 3.2, which neither DISPLAY nor Xvfb offers");
}

PictureDisplay::~PictureDisplay ()
{
  restore ();
}

void
PictureDisplay::restore ()
{
  if (had_display_)
    setenv ("DISPLAY", old_display_.c_str (), 1);
  else
    unsetenv ("DISPLAY");
}
// NOLINTEND(concurrency-mt-unsafe)

} // namespace pcl::manifold::apps
