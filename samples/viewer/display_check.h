#pragma once

namespace pcl::manifold::apps {

/** \brief Can a window with OpenGL be opened on the display that the variable DISPLAY names? VTK ends the
 * program if it cannot. */
bool canOpenWindow ();

} // namespace pcl::manifold::apps
