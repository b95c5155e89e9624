#pragma once

#include <memory>
#include <string>

namespace pcl::manifold::apps {

class VirtualDisplay;

/** \brief Makes sure, as long as it lives, that VTK can draw: on the display of the variable DISPLAY, or, if
 * that is unset or of no use, on a virtual one, which DISPLAY then names.
 *
 * VTK ends the program where it finds no display or no OpenGL, so this is tried out in a child process first.
 */
class PictureDisplay
{
public:
  /** \throws std::runtime_error that says what to do if there is no way to draw */
  PictureDisplay ();

  PictureDisplay (const PictureDisplay&) = delete;
  PictureDisplay& operator= (const PictureDisplay&) = delete;

  ~PictureDisplay ();

  /** \brief Is it one that nobody sees? */
  bool isVirtual () const { return virtual_display_ != nullptr; }

private:
  /** \brief Gives DISPLAY the value that it had. */
  void restore ();

  std::unique_ptr<VirtualDisplay> virtual_display_;
  bool had_display_ = false;
  std::string old_display_;
};

} // namespace pcl::manifold::apps
