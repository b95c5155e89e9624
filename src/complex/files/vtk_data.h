#pragma once

#include "complex/files/cloud_fields.h"
#include "complex/files/formats.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace pcl {
namespace manifold {

/** \brief VTK's numbers of the cell types that can be taken into a complex. */
enum VtkCellType : std::uint8_t
{
  VTK_CELL_EMPTY = 0,
  VTK_CELL_VERTEX = 1,
  VTK_CELL_POLY_VERTEX = 2,
  VTK_CELL_LINE = 3,
  VTK_CELL_POLY_LINE = 4,
  VTK_CELL_TRIANGLE = 5,
  VTK_CELL_TRIANGLE_STRIP = 6,
  VTK_CELL_POLYGON = 7,
  VTK_CELL_PIXEL = 8,
  VTK_CELL_QUAD = 9,
  VTK_CELL_TETRA = 10
};

/** \brief One array of a VTK file, its values in this machine's byte order. */
struct VtkArray
{
  std::string name;
  ScalarType type = 0;
  std::size_t components = 1;
  std::vector<std::uint8_t> data;

  std::size_t values () const { return data.size () / sizeOf (type); }
};

/** \brief Cells of any sizes, one row after the other. */
struct VtkCells
{
  std::vector<std::int64_t> ends; ///< where each cell's vertices end
  std::vector<std::int64_t> vertices;
  std::vector<std::int64_t> types; ///< VtkCellType
};

/** \brief The values of an array of integers. \throw FileError for floating-point values */
std::vector<std::int64_t> wholeValues (const VtkArray& array);

/** \brief Puts what was read from a file of either format together.
 * \param[in] points three coordinates a point
 * \param[in] arrays point data; those named x, y or z, without a name or with that of another are skipped
 * \param[in] cells need not be consistent
 * \throw FileError with the number of the first wrong cell */
FileContent assembleVtk (const VtkArray& points, std::vector<VtkArray> arrays, const VtkCells& cells);

/** \brief The type that the coordinates of a cloud are written in: FLOAT32 if all three are that, else
 * FLOAT64.
 * \param[in] xyz the three fields */
ScalarType coordinateType (const std::array<CloudField, 3>& xyz);

} // namespace manifold
} // namespace pcl
