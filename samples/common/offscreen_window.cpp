#include "offscreen_window.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <vtkGenericOpenGLRenderWindow.h>

#include <cstdlib>
#include <stdexcept>

namespace pcl::manifold::apps {
namespace {

/** \brief What EGL offers without a screen, made ready at the first call. It stays to the end of the program,
 * because all windows share it. */
EGLDisplay
surfaceless ()
{
  static const EGLDisplay display = [] {
    // Without this EGL tries the graphics cards first, and complains of those that the user may not open.
    setenv ("LIBGL_ALWAYS_SOFTWARE", "1", 0); // NOLINT(concurrency-mt-unsafe): apps draw in one thread
    const EGLDisplay found =
      eglGetPlatformDisplay (EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    return eglInitialize (found, nullptr, nullptr) == EGL_TRUE ? found : EGL_NO_DISPLAY;
  }();
  return display;
}

/** \brief A context of OpenGL 3.2, the least that VTK takes; EGL_NO_CONTEXT if there is none. */
EGLContext
makeContext ()
{
  constexpr EGLint wanted[] = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
  constexpr EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 2, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint configs = 0;
  if (surfaceless () == EGL_NO_DISPLAY || eglBindAPI (EGL_OPENGL_API) != EGL_TRUE ||
      eglChooseConfig (surfaceless (), wanted, &config, 1, &configs) != EGL_TRUE || configs < 1)
    return EGL_NO_CONTEXT;
  return eglCreateContext (surfaceless (), config, EGL_NO_CONTEXT, version);
}

/** \brief VTK's window for a context that the program makes. Debian's VTK is built without its own window for
 * EGL. */
class EglWindow : public vtkGenericOpenGLRenderWindow
{
public:
  static EglWindow* New ()
  {
    auto* const window = new EglWindow; // counts its owners itself
    window->InitializeObjectBase ();
    return window;
  }

  EglWindow (const EglWindow&) = delete;
  EglWindow& operator= (const EglWindow&) = delete;

  void MakeCurrent () override { eglMakeCurrent (surfaceless (), EGL_NO_SURFACE, EGL_NO_SURFACE, context_); }

  bool IsCurrent () override { return context_ != EGL_NO_CONTEXT && eglGetCurrentContext () == context_; }

  void OpenGLInitContext () override
  {
    // GLEW finds the functions of OpenGL, and fails thereafter, where it looks for a display.
    vtkGenericOpenGLRenderWindow::OpenGLInitContext ();
    GlewInitValid = true;
    Initialized = true;
  }

protected:
  EglWindow () = default;

  ~EglWindow () override
  {
    if (context_ == EGL_NO_CONTEXT)
      return;
    Finalize ();
    eglMakeCurrent (surfaceless (), EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext (surfaceless (), context_);
  }

private:
  EGLContext context_ = makeContext ();
};

} // namespace

vtkSmartPointer<vtkRenderWindow>
makeOffscreenWindow ()
{
  vtkObject::GlobalWarningDisplayOff ();
  const auto window = vtkSmartPointer<EglWindow>::New ();
  window->MakeCurrent ();
  if (!window->IsCurrent ())
    throw std::runtime_error ("a picture needs OpenGL 3.2 from EGL: install libegl1 and libgl1-mesa-dri");
  window->SetOffScreenRendering (1);
  window->InitializeFromCurrentContext ();
  return window;
}

} // namespace pcl::manifold::apps
