#include "complex/files/formats.h"
#include "complex/files/value_writer.h"
#include "complex/files/vtk_data.h"

#include <functional>
#include <limits>

namespace pcl {
namespace manifold {

namespace {

using Field = pcl::PCLPointField;

const char*
vtuTypeName (ScalarType type)
{
  switch (type) {
    case Field::INT8:
      return "Int8";
    case Field::UINT8:
      return "UInt8";
    case Field::INT16:
      return "Int16";
    case Field::UINT16:
      return "UInt16";
    case Field::INT32:
      return "Int32";
    case Field::UINT32:
      return "UInt32";
    case Field::INT64:
      return "Int64";
    case Field::UINT64:
      return "UInt64";
    case Field::FLOAT32:
      return "Float32";
    default:
      return "Float64";
  }
}

std::string
escapeXml (const std::string& text)
{
  std::string escaped;
  for (const char c : text)
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        escaped += c;
    }
  return escaped;
}

/** \brief Writes a VTU file: XML that describes the arrays, and the arrays themselves, as text within the XML
 * or as bytes behind it. */
class VtuWriter
{
public:
  VtuWriter (OutputFile& file, const CloudFields& cloud, const FileCells& cells, bool ascii)
    : writer_ (file, ascii                ? Encoding::TEXT
                     : host_is_big_endian ? Encoding::BINARY_BIG
                                          : Encoding::BINARY_LITTLE),
      cloud_ (cloud), complex_ (cells.complex), polygons_ (cells.polygons), ascii_ (ascii)
  {}

  void write ()
  {
    const std::size_t cells =
      complex_.edges.size () + complex_.triangles.size () + complex_.tetrahedra.size () + polygons_.size ();
    writer_.text (std::string ("<?xml version=\"1.0\"?>\n<!-- written by pcl_manifold -->\n"
                               "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"") +
                  (host_is_big_endian ? "BigEndian" : "LittleEndian") +
                  "\" header_type=\"UInt64\">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"" +
                  std::to_string (cloud_.points ()) + "\" NumberOfCells=\"" + std::to_string (cells) +
                  "\">\n");
    writePoints ();
    writeCells (cells);
    writePointData ();
    writer_.text ("</Piece>\n</UnstructuredGrid>\n");
    if (!ascii_)
      writeAppended ();
    writer_.text ("</VTKFile>\n");
    writer_.finish ();
  }

private:
  /** \brief Writes an array, or its description now and its values with the appended data.
   * \param[in] size bytes of all values
   * \param[in] values writes the values, one row a point or cell */
  void writeArray (const std::string& name, ScalarType type, std::size_t components, std::size_t size,
                   const std::function<void ()>& values)
  {
    writer_.text (std::string ("<DataArray type=\"") + vtuTypeName (type) + "\" Name=\"" + escapeXml (name) +
                  "\" NumberOfComponents=\"" + std::to_string (components) + "\" format=\"");
    if (ascii_) {
      writer_.text ("ascii\">\n");
      values ();
      writer_.text ("</DataArray>\n");
      return;
    }
    writer_.text ("appended\" offset=\"" + std::to_string (offset_) + "\"/>\n");
    offset_ += sizeof (std::uint64_t) + size;
    appended_.push_back ([this, size, values] {
      writer_.value (static_cast<std::uint64_t> (size));
      values ();
    });
  }

  void writeAppended ()
  {
    writer_.text ("<AppendedData encoding=\"raw\">\n_");
    for (const auto& write_values : appended_)
      write_values ();
    writer_.text ("\n</AppendedData>\n");
  }

  void writePoints ()
  {
    const auto xyz = cloud_.coordinates ();
    const ScalarType type = coordinateType (xyz);
    writer_.text ("<Points>\n");
    writeArray ("Points", type, 3, 3 * cloud_.points () * sizeOf (type), [this, xyz, type] {
      for (std::size_t i = 0; i < cloud_.points (); ++i) {
        for (const CloudField& field : xyz) {
          const double value = toDouble (field.type, cloud_.point (i) + field.offset);
          if (type == Field::FLOAT64)
            writer_.value (value);
          else
            writer_.value (static_cast<float> (value));
        }
        writer_.endRow ();
      }
    });
    writer_.text ("</Points>\n");
  }

  /** \brief Calls f (type, first vertex, end of the vertices) for every cell. */
  template <typename Function>
  void forEachCell (Function f) const
  {
    for (const auto& edge : complex_.edges)
      f (VTK_CELL_LINE, edge.data (), edge.data () + edge.size ());
    for (const auto& triangle : complex_.triangles)
      f (VTK_CELL_TRIANGLE, triangle.data (), triangle.data () + triangle.size ());
    for (const auto& tetrahedron : complex_.tetrahedra)
      f (VTK_CELL_TETRA, tetrahedron.data (), tetrahedron.data () + tetrahedron.size ());
    for (std::size_t i = 0; i < polygons_.size (); ++i)
      f (VTK_CELL_POLYGON, polygons_.vertices.data () + polygons_.starts[i],
         polygons_.vertices.data () + polygons_.starts[i + 1]);
  }

  template <typename Integer>
  void writeCellArrays (ScalarType type, std::size_t cells, std::size_t corners)
  {
    writeArray ("connectivity", type, 1, corners * sizeof (Integer), [this] {
      forEachCell ([this] (VtkCellType, const pcl::index_t* begin, const pcl::index_t* end) {
        for (const pcl::index_t* v = begin; v != end; ++v)
          writer_.value (static_cast<Integer> (*v));
        writer_.endRow ();
      });
    });
    writeArray ("offsets", type, 1, cells * sizeof (Integer), [this] {
      Integer offset = 0;
      forEachCell ([this, &offset] (VtkCellType, const pcl::index_t* begin, const pcl::index_t* end) {
        offset += static_cast<Integer> (end - begin);
        writer_.value (offset);
        writer_.endRow ();
      });
    });
  }

  void writeCells (std::size_t cells)
  {
    const std::size_t corners = 2 * complex_.edges.size () + 3 * complex_.triangles.size () +
                                4 * complex_.tetrahedra.size () + polygons_.vertices.size ();
    writer_.text ("<Cells>\n");
    if (corners <= static_cast<std::size_t> (std::numeric_limits<std::int32_t>::max ()))
      writeCellArrays<std::int32_t> (Field::INT32, cells, corners);
    else
      writeCellArrays<std::int64_t> (Field::INT64, cells, corners);
    writeArray ("types", Field::UINT8, 1, cells, [this] {
      forEachCell ([this] (VtkCellType type, const pcl::index_t*, const pcl::index_t*) {
        writer_.value (static_cast<std::uint8_t> (type));
        writer_.endRow ();
      });
    });
    writer_.text ("</Cells>\n");
  }

  void writePointData ()
  {
    writer_.text ("<PointData>\n");
    for (const CloudField& field : cloud_.attributes ())
      writeArray (field.name, field.type, field.count, cloud_.points () * field.size (), [this, field] {
        std::vector<std::uint8_t> values (field.size ());
        for (std::size_t i = 0; i < cloud_.points (); ++i) {
          field.copy (cloud_.point (i), values.data ());
          writer_.values (field.type, values.data (), field.count);
          writer_.endRow ();
        }
      });
    writer_.text ("</PointData>\n<CellData>\n</CellData>\n");
  }

  ValueWriter writer_;
  const CloudFields& cloud_;
  const SimplicialComplex& complex_;
  const FaceRows& polygons_;
  const bool ascii_;
  std::size_t offset_ = 0; ///< of the next array in the appended data
  std::vector<std::function<void ()>> appended_;
};

} // namespace

void
writeVtu (OutputFile& file, const CloudFields& cloud, const FileCells& cells, bool ascii)
{
  VtuWriter (file, cloud, cells, ascii).write ();
}

} // namespace manifold
} // namespace pcl
