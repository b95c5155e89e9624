#pragma once

#include <string>

#include <sys/types.h>

namespace pcl::manifold::apps {

/** \brief An X server of our own without a screen, Xvfb, that runs as long as the object lives. */
class VirtualDisplay
{
public:
  /** \brief Starts it on a free display.
   * \throws std::runtime_error if Xvfb is not installed or does not start */
  VirtualDisplay ();

  VirtualDisplay (const VirtualDisplay&) = delete;
  VirtualDisplay& operator= (const VirtualDisplay&) = delete;

  ~VirtualDisplay ();

  /** \brief Its name, as for the variable DISPLAY. */
  const std::string& name () const { return name_; }

private:
  void stop ();

  pid_t process_ = -1;
  std::string name_;
};

} // namespace pcl::manifold::apps
