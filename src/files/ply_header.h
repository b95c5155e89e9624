#pragma once

#include "files/scalar_type.h"
#include "files/scanner.h"
#include "files/value_writer.h"

#include <cstddef>
#include <string>
#include <vector>

namespace pcl::manifold {

struct PlyProperty
{
  std::string name;
  ScalarType type = 0;
  bool is_list = false;
  ScalarType length_type = 0; ///< of a list
};

struct PlyElement
{
  std::string name;
  std::size_t count = 0;
  std::vector<PlyProperty> properties;
};

struct PlyHeader
{
  Encoding encoding = Encoding::TEXT;
  std::vector<PlyElement> elements;
  std::size_t columns = 0; ///< of an organised cloud, with rows; unchecked
  std::size_t rows = 0;
};

/** \brief Reads a header and leaves the scanner at the first element. No count in it is larger than the rest
 * of the file allows. \throw FileError with the line */
PlyHeader readPlyHeader (Scanner& scanner);

/** \brief PLY's name of a type. PLY has no integers of 64 bits. */
const char* plyTypeName (ScalarType type);

} // namespace pcl::manifold
