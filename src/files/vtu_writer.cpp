#include "files/vtk_common.h"

#include <functional>
#include <limits>

namespace pcl::manifold {
namespace {

using Field = pcl::PCLPointField;

std::string
escapeXml (const std::string& text)
{
  std::string escaped;
  for (const char c : text)
    escaped += c == '&'   ? "&amp;"
               : c == '<' ? "&lt;"
               : c == '>' ? "&gt;"
               : c == '"' ? "&quot;"
                          : std::string (1, c);
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
      cloud_ (cloud), cells_ (cells), ascii_ (ascii)
  {}

  void write ()
  {
    writer_.text (std::string ("<?xml version=\"1.0\"?>\n<!-- written by pcl_manifold -->\n"
                               "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"") +
                  (host_is_big_endian ? "BigEndian" : "LittleEndian") +
                  "\" header_type=\"UInt64\">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"" +
                  std::to_string (cloud_.points ()) + "\" NumberOfCells=\"" +
                  std::to_string (countCells (cells_)) + "\">\n");
    writePoints ();
    writeCells ();
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
    writer_.text (std::string ("<DataArray type=\"") + vtkTypeNames (type).xml + "\" Name=\"" +
                  escapeXml (name) + "\" NumberOfComponents=\"" + std::to_string (components) +
                  "\" format=\"");
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
    const ScalarType type = coordinateType (cloud_);
    writer_.text ("<Points>\n");
    writeArray ("Points", type, 3, 3 * cloud_.points () * sizeOf (type),
                [this] { writeCoordinates (writer_, cloud_); });
    writer_.text ("</Points>\n");
  }

  template <typename Integer>
  void writeCellArrays (ScalarType type)
  {
    writeArray ("connectivity", type, 1, countCorners (cells_) * sizeof (Integer), [this] {
      forEachCell (cells_, [this] (VtkCellType, const pcl::index_t* begin, const pcl::index_t* end) {
        for (const pcl::index_t* v = begin; v != end; ++v)
          writer_.value (static_cast<Integer> (*v));
        writer_.endRow ();
      });
    });
    writeArray ("offsets", type, 1, countCells (cells_) * sizeof (Integer), [this] {
      Integer offset = 0;
      forEachCell (cells_, [this, &offset] (VtkCellType, const pcl::index_t* begin, const pcl::index_t* end) {
        offset += static_cast<Integer> (end - begin);
        writer_.value (offset);
        writer_.endRow ();
      });
    });
  }

  void writeCells ()
  {
    writer_.text ("<Cells>\n");
    if (countCorners (cells_) <= static_cast<std::size_t> (std::numeric_limits<std::int32_t>::max ()))
      writeCellArrays<std::int32_t> (Field::INT32);
    else
      writeCellArrays<std::int64_t> (Field::INT64);
    writeArray ("types", Field::UINT8, 1, countCells (cells_), [this] {
      forEachCell (cells_, [this] (VtkCellType type, const pcl::index_t*, const pcl::index_t*) {
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
      writeArray (field.name, field.type, field.count, cloud_.points () * field.size (),
                  [this, field] { writeField (writer_, cloud_, field); });
    writer_.text ("</PointData>\n<CellData>\n</CellData>\n");
  }

  ValueWriter writer_;
  const CloudFields& cloud_;
  const FileCells& cells_;
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

} // namespace pcl::manifold
