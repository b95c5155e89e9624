#pragma once

#include "complex/files/scanner.h"
#include "complex/files/vtk_data.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace pcl {
namespace manifold {

/** \brief A type's name in legacy VTK files. */
const char* vtkTypeName (ScalarType type);

/** \brief Reads the arrays of a legacy VTK file. */
class VtkValues
{
public:
  Scanner scanner;
  bool ascii = true;

  explicit VtkValues (std::string_view bytes) : scanner (bytes) {}

  /** \brief Reads the name of a type from the current line. */
  ScalarType readType ();

  /** \brief Reads the name of a type from the current line, and then an array of that type. */
  VtkArray readTyped (const std::string& name, std::size_t tuples, std::size_t components);

  /** \brief Reads an array; binary data start on the next line.
   * \throw FileError if the file cannot hold so many values, or at the first that is none */
  VtkArray readArray (const std::string& name, ScalarType type, std::size_t tuples, std::size_t components);

  /** \brief Reads so many integers, stored with 32 bits. */
  std::vector<std::int64_t> readIntegers (std::size_t count);

private:
  void readText (VtkArray& array, std::size_t values);

  void readBinary (VtkArray& array, std::size_t values);
};

} // namespace manifold
} // namespace pcl
