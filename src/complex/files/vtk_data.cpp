#include "complex/files/vtk_data.h"

#include "complex/files/file_error.h"
#include "complex/files/scanner.h"
#include "complex/files/simplex_collector.h"

#include <algorithm>
#include <set>
#include <utility>

namespace pcl {
namespace manifold {

namespace {

using Field = pcl::PCLPointField;

/** \brief The coordinates as the fields x, y and z, integers as FLOAT64. */
std::vector<CloudColumn>
coordinateColumns (const VtkArray& points)
{
  const bool narrow = points.type == Field::FLOAT32;
  const std::size_t from_size = sizeOf (points.type), size = narrow ? sizeof (float) : sizeof (double);
  const std::size_t count = points.values () / 3;
  std::vector<CloudColumn> columns;
  for (std::size_t k = 0; k < 3; ++k) {
    columns.push_back ({std::string (1, static_cast<char> ('x' + k)),
                        static_cast<ScalarType> (narrow ? Field::FLOAT32 : Field::FLOAT64),
                        1,
                        {}});
    std::vector<std::uint8_t>& data = columns.back ().data;
    data.resize (count * size);
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint8_t* value = points.data.data () + (3 * i + k) * from_size;
      const double wide = toDouble (points.type, value);
      std::memcpy (data.data () + i * size, narrow ? static_cast<const void*> (value) : &wide, size);
    }
  }
  return columns;
}

/** \brief Takes one cell.
 * \return false if its type cannot be taken or has another number of vertices */
bool
takeCell (std::int64_t type, const pcl::Indices& cell, SimplexCollector& collector)
{
  switch (type) {
    case VTK_CELL_EMPTY:
    case VTK_CELL_VERTEX:
    case VTK_CELL_POLY_VERTEX:
      return true;
    case VTK_CELL_LINE:
    case VTK_CELL_POLY_LINE:
      collector.addPolyline (cell.data (), cell.size ());
      return true;
    case VTK_CELL_TRIANGLE:
    case VTK_CELL_POLYGON:
    case VTK_CELL_QUAD:
      collector.addPolygon (cell.data (), cell.size ());
      return true;
    case VTK_CELL_TRIANGLE_STRIP: // every other triangle of a strip is the other way around
      for (std::size_t i = 2; i < cell.size (); ++i)
        collector.addTriangle (cell[i - 2], cell[i - 1 + i % 2], cell[i - i % 2]);
      return true;
    case VTK_CELL_PIXEL: // its last two vertices are not in order around it
      if (cell.size () != 4)
        return false;
      collector.addTriangle (cell[0], cell[1], cell[3]);
      collector.addTriangle (cell[0], cell[3], cell[2]);
      return true;
    case VTK_CELL_TETRA:
      if (cell.size () != 4)
        return false;
      collector.addTetrahedron (cell[0], cell[1], cell[2], cell[3]);
      return true;
    default:
      return false;
  }
}

void
takeCells (const VtkCells& cells, std::size_t points, SimplicialComplex& complex)
{
  if (cells.types.size () != cells.ends.size ())
    throw FileError (std::to_string (cells.ends.size ()) + " cells, but " +
                     std::to_string (cells.types.size ()) + " cell types");
  SimplexCollector collector (complex);
  pcl::Indices cell;
  std::int64_t begin = 0;
  for (std::size_t c = 0; c < cells.ends.size (); begin = cells.ends[c++]) {
    const auto fail = [c] (const std::string& why) {
      throw FileError ("cell " + std::to_string (c) + " " + why);
    };
    const std::int64_t end = cells.ends[c];
    if (end < begin || end > static_cast<std::int64_t> (cells.vertices.size ()))
      fail ("is outside of the list of vertices");
    cell.clear ();
    for (std::int64_t i = begin; i < end; ++i) {
      const std::int64_t vertex = cells.vertices[static_cast<std::size_t> (i)];
      if (vertex < 0 || static_cast<std::size_t> (vertex) >= points)
        fail ("has point " + std::to_string (vertex) + ", which there is not");
      cell.push_back (static_cast<pcl::index_t> (vertex));
    }
    if (!takeCell (cells.types[c], cell, collector))
      fail ("of type " + std::to_string (cells.types[c]) + " is no point, line, polygon or tetrahedron");
  }
}

} // namespace

std::vector<std::int64_t>
wholeValues (const VtkArray& array)
{
  return withType (array.type, [&] (auto value) -> std::vector<std::int64_t> {
    if (std::is_floating_point_v<decltype (value)>)
      throw FileError ("the array " + quoted (array.name) + " has no whole numbers");
    std::vector<std::int64_t> values (array.values ());
    for (std::size_t i = 0; i < values.size (); ++i) {
      std::memcpy (&value, array.data.data () + i * sizeof (value), sizeof (value));
      values[i] = static_cast<std::int64_t> (value);
    }
    return values;
  });
}

FileContent
assembleVtk (const VtkArray& points, std::vector<VtkArray> arrays, const VtkCells& cells)
{
  std::vector<CloudColumn> columns = coordinateColumns (points);
  std::set<std::string> names = {"", "_", "x", "y", "z"};
  for (VtkArray& array : arrays) {
    if (array.components == 0 || !names.insert (array.name).second)
      continue;
    if (array.values () / array.components != points.values () / 3)
      throw FileError ("the array " + quoted (array.name) + " has not one entry a point");
    columns.push_back ({array.name, array.type, array.components, std::move (array.data)});
  }
  FileContent content;
  content.cloud = makeCloud (columns, points.values () / 3);
  takeCells (cells, points.values () / 3, content.complex);
  return content;
}

ScalarType
coordinateType (const std::array<CloudField, 3>& xyz)
{
  return std::all_of (xyz.begin (), xyz.end (), [] (const CloudField& f) { return f.type == Field::FLOAT32; })
           ? Field::FLOAT32
           : Field::FLOAT64;
}

} // namespace manifold
} // namespace pcl
