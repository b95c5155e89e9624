#pragma once

#include "scene.h"

#include <string>
#include <vector>

namespace pcl::manifold::apps {

/** \brief Draws panels with VTK, as Picture::draw () describes.
 * \return the bytes of a PNG file; empty if nothing could be drawn */
std::string renderPanels (const std::string& title, const std::vector<Panel>& panels, int width, int height);

} // namespace pcl::manifold::apps
