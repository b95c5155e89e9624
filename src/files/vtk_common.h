#pragma once

#include "files/formats.h"
#include "files/value_writer.h"

#include <algorithm>
#include <iterator>

namespace pcl::manifold {

/** \brief VTK's numbers of the cell types that are written. */
enum VtkCellType : std::uint8_t
{
  VTK_CELL_LINE = 3,
  VTK_CELL_TRIANGLE = 5,
  VTK_CELL_POLYGON = 7,
  VTK_CELL_TETRA = 10
};

/** \brief What a type is called in either format. */
struct VtkTypeNames
{
  ScalarType type;
  const char* legacy;
  const char* xml;
};

inline const VtkTypeNames&
vtkTypeNames (ScalarType type)
{
  using Field = pcl::PCLPointField;
  static constexpr VtkTypeNames names[] = {
    {Field::INT8, "char", "Int8"},           {Field::UINT8, "unsigned_char", "UInt8"},
    {Field::INT16, "short", "Int16"},        {Field::UINT16, "unsigned_short", "UInt16"},
    {Field::INT32, "int", "Int32"},          {Field::UINT32, "unsigned_int", "UInt32"},
    {Field::INT64, "vtktypeint64", "Int64"}, {Field::UINT64, "vtktypeuint64", "UInt64"},
    {Field::FLOAT32, "float", "Float32"},    {Field::FLOAT64, "double", "Float64"}};
  return *std::find_if (std::begin (names), std::end (names),
                        [type] (const VtkTypeNames& known) { return known.type == type; });
}

/** \brief Calls f (type, first vertex, end of the vertices) for every cell. */
template <typename Function>
void
forEachCell (const FileCells& cells, Function f)
{
  for (const auto& edge : cells.complex.edges)
    f (VTK_CELL_LINE, edge.data (), edge.data () + edge.size ());
  for (const auto& triangle : cells.complex.triangles)
    f (VTK_CELL_TRIANGLE, triangle.data (), triangle.data () + triangle.size ());
  for (const auto& tetrahedron : cells.complex.tetrahedra)
    f (VTK_CELL_TETRA, tetrahedron.data (), tetrahedron.data () + tetrahedron.size ());
  const FaceRows& polygons = cells.polygons;
  for (std::size_t i = 0; i < polygons.size (); ++i)
    f (VTK_CELL_POLYGON, polygons.vertices.data () + polygons.starts[i],
       polygons.vertices.data () + polygons.starts[i + 1]);
}

inline std::size_t
countCells (const FileCells& cells)
{
  const SimplicialComplex& complex = cells.complex;
  return complex.edges.size () + complex.triangles.size () + complex.tetrahedra.size () +
         cells.polygons.size ();
}

/** \brief Vertices of all cells together. */
inline std::size_t
countCorners (const FileCells& cells)
{
  const SimplicialComplex& complex = cells.complex;
  return 2 * complex.edges.size () + 3 * complex.triangles.size () + 4 * complex.tetrahedra.size () +
         cells.polygons.vertices.size ();
}

/** \brief The type that the coordinates of a cloud are written in: FLOAT32 if all three are that, else
 * FLOAT64. */
inline ScalarType
coordinateType (const CloudFields& cloud)
{
  const auto xyz = cloud.coordinates ();
  const bool narrow = std::all_of (xyz.begin (), xyz.end (), [] (const CloudField& field) {
    return field.type == pcl::PCLPointField::FLOAT32;
  });
  return narrow ? pcl::PCLPointField::FLOAT32 : pcl::PCLPointField::FLOAT64;
}

/** \brief Writes the coordinates, a row a point, in the coordinateType (). */
inline void
writeCoordinates (ValueWriter& writer, const CloudFields& cloud)
{
  const auto xyz = cloud.coordinates ();
  const bool narrow = coordinateType (cloud) == pcl::PCLPointField::FLOAT32;
  for (std::size_t i = 0; i < cloud.points (); ++i) {
    for (const CloudField& field : xyz) {
      const double value = toDouble (field.type, cloud.point (i) + field.offset);
      if (narrow)
        writer.value (static_cast<float> (value));
      else
        writer.value (value);
    }
    writer.endRow ();
  }
}

/** \brief Writes the values of a field, a row a point. */
inline void
writeField (ValueWriter& writer, const CloudFields& cloud, const CloudField& field)
{
  std::vector<std::uint8_t> values (field.size ());
  for (std::size_t i = 0; i < cloud.points (); ++i) {
    field.copy (cloud.point (i), values.data ());
    writer.values (field.type, values.data (), field.count);
    writer.endRow ();
  }
}

} // namespace pcl::manifold
