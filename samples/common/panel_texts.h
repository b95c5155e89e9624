#pragma once

#include "scene.h"

#include <vtkRenderer.h>

#include <string>
#include <vector>

namespace pcl::manifold::apps {

/** \brief A picture is drawn so many times larger than it will be, and shrunk, which smooths its edges. Sizes
 * and positions in pixels are those of the shrunk picture. */
constexpr int oversampling = 2;

/** \brief Writes a line of text, from a position in the viewport on, whose lower left corner is (0, 0). */
void addText (vtkRenderer& renderer, const std::string& text, double x, double y, int size, bool bold);

/** \brief Lists the layers that have a name, from the lower left corner up; the first one is on top. */
void addLegend (vtkRenderer& renderer, const std::vector<Layer>& layers);

/** \brief Height of what addLegend () lists. */
double legendHeight (const std::vector<Layer>& layers);

} // namespace pcl::manifold::apps
