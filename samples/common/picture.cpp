#include "picture.h"

#include "app_files.h"
#include "offscreen_window.h"
#include "render_panels.h"

#include <stdexcept>

namespace pcl::manifold::apps {

Picture::Picture (const std::string& file) : file_ (file)
{
  if (!wanted ())
    return;
  checkWritable (file);
  try {
    makeOffscreenWindow ();
  } catch (const std::runtime_error& error) {
    throw AppError (file, error.what ());
  }
}

void
Picture::draw (const std::string& title, const std::vector<Panel>& panels, int width, int height) const
{
  if (wanted ())
    writePicture (file_, title, panels, width, height);
}

void
writePicture (const std::string& file, const std::string& title, const std::vector<Panel>& panels, int width,
              int height)
{
  const std::string png = renderPanels (title, panels, width, height);
  if (png.empty ())
    throw AppError (file, "the picture could not be drawn");
  writeFile (file, png);
}

} // namespace pcl::manifold::apps
