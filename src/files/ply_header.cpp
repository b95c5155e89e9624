#include "files/ply_header.h"

#include <algorithm>
#include <array>
#include <utility>

namespace pcl::manifold {
namespace {

using Field = pcl::PCLPointField;

/** \brief The types with their old and their new names. */
constexpr std::array<std::pair<ScalarType, std::array<const char*, 2>>, 8> types = {{
  {Field::INT8, {"char", "int8"}},
  {Field::UINT8, {"uchar", "uint8"}},
  {Field::INT16, {"short", "int16"}},
  {Field::UINT16, {"ushort", "uint16"}},
  {Field::INT32, {"int", "int32"}},
  {Field::UINT32, {"uint", "uint32"}},
  {Field::FLOAT32, {"float", "float32"}},
  {Field::FLOAT64, {"double", "float64"}},
}};

ScalarType
readType (Scanner& scanner)
{
  const std::string_view name = scanner.wordOnLine ();
  for (const auto& [type, names] : types)
    if (name == names[0] || name == names[1])
      return type;
  scanner.failAtWord ("a type", name);
}

std::string
readName (Scanner& scanner)
{
  const std::string_view name = scanner.wordOnLine ();
  if (name.empty ())
    scanner.failAtWord ("a name", name);
  return std::string (name);
}

template <typename Named>
bool
hasName (const std::vector<Named>& things, const std::string& name)
{
  return std::any_of (things.begin (), things.end (),
                      [&] (const Named& thing) { return thing.name == name; });
}

Encoding
readFormat (Scanner& scanner)
{
  const std::string_view format = scanner.wordOnLine ();
  if (format == "ascii")
    return Encoding::TEXT;
  if (format == "binary_little_endian")
    return Encoding::BINARY_LITTLE;
  if (format == "binary_big_endian")
    return Encoding::BINARY_BIG;
  scanner.failAtWord ("a PLY format", format);
}

PlyElement
readElement (Scanner& scanner, const PlyHeader& header)
{
  PlyElement element;
  element.name = readName (scanner);
  if (hasName (header.elements, element.name))
    scanner.failAtLine ("a second element " + quoted (element.name));
  const std::string_view count = scanner.wordOnLine ();
  if (!parseNumber (count, element.count))
    scanner.failAtWord ("how many " + quoted (element.name) + " there are", count);
  return element;
}

PlyProperty
readProperty (Scanner& scanner, const PlyElement& element)
{
  PlyProperty property;
  const std::size_t start = scanner.position ();
  if (scanner.wordOnLine () == "list") {
    property.is_list = true;
    property.length_type = readType (scanner);
    if (property.length_type == Field::FLOAT32 || property.length_type == Field::FLOAT64)
      scanner.failAtLine ("the length of a list is no whole number");
  } else
    scanner.seek (start);
  property.type = readType (scanner);
  property.name = readName (scanner);
  if (hasName (element.properties, property.name))
    scanner.failAtLine ("a second property " + quoted (property.name) + " of " + quoted (element.name));
  return property;
}

/** \brief Reads the rows and columns of an organised cloud, as PCL writes them; other information is skipped. */
void
readInfo (Scanner& scanner, PlyHeader& header)
{
  const std::string_view name = scanner.wordOnLine ();
  std::size_t number = 0;
  if (parseNumber (scanner.wordOnLine (), number) && name == "num_cols")
    header.columns = number;
  else if (name == "num_rows")
    header.rows = number;
}

/** \brief Fails where the rest of the file cannot hold what the header promises. */
void
checkCounts (const PlyHeader& header, const Scanner& scanner)
{
  for (const PlyElement& element : header.elements) {
    std::size_t least = 0;
    for (const PlyProperty& property : element.properties)
      least += header.encoding == Encoding::TEXT
                 ? 2 // a digit and what separates it from the next
                 : sizeOf (property.is_list ? property.length_type : property.type);
    if (least > 0 && element.count > (scanner.remaining () + 1) / least)
      scanner.failAtLine ("the header promises " + std::to_string (element.count) + " of " +
                          quoted (element.name) + ", more than the file can hold");
  }
}

} // namespace

PlyHeader
readPlyHeader (Scanner& scanner)
{
  if (scanner.wordOnLine () != "ply" || !scanner.wordOnLine ().empty ())
    scanner.failAtLine ("not a PLY file");
  scanner.line ();
  PlyHeader header;
  bool has_format = false;
  while (true) {
    if (scanner.remaining () == 0)
      scanner.failAtLine ("the header has no end");
    const std::string_view keyword = scanner.wordOnLine ();
    if (keyword == "end_header")
      break;
    if (keyword == "format") {
      header.encoding = readFormat (scanner);
      has_format = true;
    } else if (keyword == "element")
      header.elements.push_back (readElement (scanner, header));
    else if (keyword == "property" && !header.elements.empty ())
      header.elements.back ().properties.push_back (readProperty (scanner, header.elements.back ()));
    else if (keyword == "obj_info")
      readInfo (scanner, header);
    else if (!keyword.empty () && keyword != "comment")
      scanner.failAtWord ("a PLY header", keyword);
    scanner.line ();
  }
  if (!has_format)
    scanner.failAtLine ("the header has no format");
  checkCounts (header, scanner);
  scanner.line ();
  return header;
}

const char*
plyTypeName (ScalarType type)
{
  for (const auto& [known, names] : types)
    if (known == type)
      return names[0];
  return "double";
}

} // namespace pcl::manifold
