#include "scene.h"

#include "table.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl::manifold::apps {

Colour
dimensionColour (int dimension)
{
  switch (dimension) {
    case 1:
      return {0.90, 0.38, 0.00};
    case 2:
      return {0.20, 0.48, 0.80};
    case 3:
      return {0.10, 0.60, 0.40};
    default:
      return {0.55, 0.55, 0.55};
  }
}

std::string
dimensionName (int dimension)
{
  switch (dimension) {
    case 1:
      return "curve";
    case 2:
      return "surface";
    case 3:
      return "solid";
    default:
      return "other";
  }
}

double
pointSize (std::size_t count)
{
  return std::clamp (9.0 - 1.6 * std::log10 (static_cast<double> (std::max<std::size_t> (count, 10)) / 10),
                     1.0, 9.0);
}

std::vector<Layer>
layersByDimension (const std::shared_ptr<const Positions>& positions,
                   const std::vector<std::uint8_t>& dimensions)
{
  std::vector<Layer> layers (4);
  for (std::size_t i = 0; i < dimensions.size (); ++i)
    layers[dimensions[i] <= 3 ? dimensions[i] : 0].corners.push_back (static_cast<std::int32_t> (i));
  std::vector<Layer> used;
  for (const int dimension : {1, 2, 3, 0}) {
    Layer& layer = layers[dimension];
    if (layer.corners.empty ())
      continue;
    layer.positions = positions;
    layer.colour = dimensionColour (dimension);
    layer.name = dimensionName (dimension) + ": " + grouped (layer.corners.size ()) + " points";
    used.push_back (std::move (layer));
  }
  return used;
}

} // namespace pcl::manifold::apps
