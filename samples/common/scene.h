#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace pcl::manifold::apps {

/** \brief Positions that layers draw from; those that are not finite are left out, with all that uses them.
 */
using Positions = std::vector<std::array<float, 3>>;

/** \brief Red, green and blue in [0, 1]. */
using Colour = std::array<double, 3>;

/** \brief Points, line segments or triangles of one colour. */
struct Layer
{
  enum class Kind
  {
    POINTS = 1, ///< the number of corners of an element
    LINES = 2,
    TRIANGLES = 3
  };

  Kind kind = Kind::POINTS;
  std::shared_ptr<const Positions> positions; ///< may be shared between layers
  std::vector<std::int32_t> corners;          ///< indices into the positions: 1, 2 or 3 for each element
  Colour colour{0.5, 0.5, 0.5};
  std::string name;    ///< in the legend; empty: not in it
  double size = 0;     ///< of points and lines, in pixels; 0: chosen by their number
  bool smooth = false; ///< shade triangles as parts of a smooth surface; otherwise each is flat
};

/** \brief A part of a picture with a caption of its own. All panels are seen from the same side. */
struct Panel
{
  std::string caption;
  std::vector<Layer> layers;
};

/** \brief In pixels: many points are drawn small, few large. */
double pointSize (std::size_t count);

/** \brief Colours of dimensions 0 (unknown, grey) to 3, apart for colour-blind eyes too: curves orange,
 * surfaces blue, solids green. */
Colour dimensionColour (int dimension);

/** \brief The legend's name of dimension 0 to 3: other, curve, surface, solid. */
std::string dimensionName (int dimension);

/** \brief One layer of points for every dimension from 1 to 3 that occurs, and one for all other labels.
 * \param[in] positions the points
 * \param[in] dimensions a label for each point */
std::vector<Layer> layersByDimension (const std::shared_ptr<const Positions>& positions,
                                      const std::vector<std::uint8_t>& dimensions);

} // namespace pcl::manifold::apps
