#include "complex/files/file_error.h"
#include "complex/files/formats.h"
#include "complex/files/scanner.h"
#include "complex/files/vtk_data.h"
#include "complex/files/vtu_values.h"
#include "complex/files/xml_tags.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace pcl {
namespace manifold {

namespace {

using Field = pcl::PCLPointField;

constexpr std::array<std::pair<std::string_view, ScalarType>, 10> types = {{
  {"Int8", Field::INT8},
  {"UInt8", Field::UINT8},
  {"Int16", Field::INT16},
  {"UInt16", Field::UINT16},
  {"Int32", Field::INT32},
  {"UInt32", Field::UINT32},
  {"Int64", Field::INT64},
  {"UInt64", Field::UINT64},
  {"Float32", Field::FLOAT32},
  {"Float64", Field::FLOAT64},
}};

/** \brief What the XML says about an array. */
struct ArrayTag
{
  XmlTag tag;
  std::string_view text; ///< within the tag
};

/** \brief Reads a VTU file of one piece: first its tags, then the arrays that are needed. */
class VtuReader
{
public:
  explicit VtuReader (std::string_view bytes) : bytes_ (bytes), tags_ (bytes) {}

  FileContent read ()
  {
    readTags ();
    const VtkArray points = readPoints ();
    std::vector<VtkArray> arrays;
    for (const ArrayTag& array : point_data_)
      if (std::optional<VtkArray> values = readArray (array))
        arrays.push_back (std::move (*values));
    return assembleVtk (points, std::move (arrays), readCells ());
  }

private:
  void readTags ()
  {
    XmlTag tag;
    if (!tags_.next (tag) || tag.name != "VTKFile")
      tags_.fail ("not a VTK file");
    readEncoding (tag);
    std::string section;
    while (tags_.next (tag)) {
      if (tag.name == "AppendedData" && tag.opens) {
        findAppended (tag);
        break; // raw data are no XML
      }
      if (tag.name == "Piece" && tag.opens && ++pieces_ > 1)
        tags_.fail ("a second piece: only files of one piece can be read");
      if (tag.name == "DataArray" && tag.opens)
        keepArray (tag, section);
      else if (isSection (tag.name))
        section = tag.opens && !tag.closes ? tag.name : "";
    }
    if (pieces_ == 0)
      throw FileError ("the file has no piece of a grid");
  }

  static bool isSection (const std::string& name)
  {
    return name == "Points" || name == "Cells" || name == "PointData" || name == "CellData" ||
           name == "FieldData";
  }

  void readEncoding (const XmlTag& tag)
  {
    if (tag["type"] != "UnstructuredGrid")
      tags_.fail ("no unstructured grid but " + quoted (tag["type"]));
    encoding_.big_endian = tag["byte_order"] == "BigEndian";
    encoding_.wide_header = tag["header_type"] == "UInt64";
    const std::string compressor = tag["compressor"];
    encoding_.zlib = compressor == "vtkZLibDataCompressor";
    if (!compressor.empty () && !encoding_.zlib)
      tags_.fail ("compressed by " + quoted (compressor) + ", which cannot be read");
  }

  void keepArray (const XmlTag& tag, const std::string& section)
  {
    ArrayTag array{tag, tag.closes ? std::string_view () : tags_.text ()};
    const std::string name = tag["Name"];
    if (section == "Points")
      points_ = array;
    else if (section == "PointData")
      point_data_.push_back (array);
    else if (section == "Cells" && name == "connectivity")
      connectivity_ = array;
    else if (section == "Cells" && name == "offsets")
      offsets_ = array;
    else if (section == "Cells" && name == "types")
      types_ = array;
  }

  void findAppended (const XmlTag& tag)
  {
    const std::size_t start = bytes_.find ('_', tags_.position ());
    if (start == std::string_view::npos)
      tags_.fail ("appended data without their start");
    appended_ = bytes_.substr (start + 1);
    appended_base64_ = tag["encoding"] == "base64";
  }

  /** \brief Reads an array's values. Empty if they are no numbers. */
  std::optional<VtkArray> readArray (const ArrayTag& source) const
  {
    const std::string name = source.tag["Name"];
    const auto* const type = std::find_if (types.begin (), types.end (),
                                           [&] (const auto& t) { return t.first == source.tag["type"]; });
    if (type == types.end ())
      return std::nullopt;
    VtkArray array{name, type->second, 1, {}};
    const std::string components = source.tag["NumberOfComponents"];
    try {
      if (!components.empty () && !parseNumber (components, array.components))
        throw FileError ("a number of components that is none");
      array.data = readValues (source, array.type);
    } catch (const FileError& error) {
      throw FileError ("array " + quoted (name) + ": " + error.what ());
    }
    return array;
  }

  std::vector<std::uint8_t> readValues (const ArrayTag& source, ScalarType type) const
  {
    const std::string format = source.tag["format"];
    if (format == "ascii")
      return readVtuText (source.text, type);
    if (format == "binary")
      return readVtuBinary (source.text, true, type, encoding_);
    std::size_t offset = 0;
    if (format != "appended" || !parseNumber (source.tag["offset"], offset) || offset > appended_.size ())
      throw FileError ("its data are not in the file");
    return readVtuBinary (appended_.substr (offset), appended_base64_, type, encoding_);
  }

  VtkArray readPoints () const
  {
    if (!points_)
      return {"Points", Field::FLOAT32, 3, {}};
    std::optional<VtkArray> points = readArray (*points_);
    if (!points || points->components != 3 || points->values () % 3 != 0)
      throw FileError ("the points do not have three coordinates each");
    return std::move (*points);
  }

  std::vector<std::int64_t> readIntegers (const std::optional<ArrayTag>& source) const
  {
    const std::optional<VtkArray> array = source ? readArray (*source) : std::nullopt;
    return array ? wholeValues (*array) : std::vector<std::int64_t> ();
  }

  VtkCells readCells () const
  {
    return {readIntegers (offsets_), readIntegers (connectivity_), readIntegers (types_)};
  }

  std::string_view bytes_;
  XmlTags tags_;
  VtuEncoding encoding_;
  int pieces_ = 0;
  std::optional<ArrayTag> points_, connectivity_, offsets_, types_;
  std::vector<ArrayTag> point_data_;
  std::string_view appended_;
  bool appended_base64_ = false;
};

} // namespace

FileContent
readVtu (std::string_view bytes)
{
  return VtuReader (bytes).read ();
}

} // namespace manifold
} // namespace pcl
