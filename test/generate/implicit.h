#pragma once

#include <generate/shape.h>

namespace generate {

/** \brief Value and gradient of a function of space. */
struct FieldValue
{
  double value;
  Eigen::Vector3d gradient;
};

using Field = std::function<FieldValue (const Eigen::Vector3d& place)>;

/** \brief The closed surface where a smooth function is 0, inside of it negative.
 * \param[in] bounds a box that holds the surface
 * \param[in] cells how many cubes of a grid are laid along the longest side of the box; fine enough to see
 * every handle
 * Points are found by marching tetrahedra and brought onto the surface by Newton's method. Uniform samples
 * are uniform up to the quality of that grid (well below one per cent). Nearest points are found by
 * iteration, right near the surface. */
Shape implicitSurface (const std::string& name, const Topology& topology, const Field& field,
                       const Eigen::AlignedBox3d& bounds, int cells = 64);

/** \brief Tori (R = 1, r = 0.4) in a row, melted together: a closed surface of genus \a handles.
 * \param[in] handles 1 to 3 */
Shape chainedTori (int handles);

/** \brief The function of which generate::chainedTori is the zero set. */
Field chainedToriField (int handles);

/** \brief A surface of genus 2. */
Shape genus2 ();

/** \brief A surface of genus 3. */
Shape genus3 ();

} // namespace generate
