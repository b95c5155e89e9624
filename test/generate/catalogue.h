#pragma once

#include <generate/shape.h>

#include <string>
#include <vector>

namespace generate {

/** \brief The names of all single shapes, curves first, then closed surfaces, open ones and solids. */
const std::vector<std::string>& shapeNames ();

/** \brief A shape in its default size.
 * \throws std::invalid_argument if there is no shape of that name */
Shape shapeByName (const std::string& name);

} // namespace generate
