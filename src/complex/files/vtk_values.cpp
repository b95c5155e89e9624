#include "complex/files/vtk_values.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

namespace pcl {
namespace manifold {

namespace {

using Field = pcl::PCLPointField;

/** \brief The first name of each type is the one to write. "long" has 64 bits where such files come from. */
constexpr std::array<std::pair<const char*, ScalarType>, 14> types = {{
  {"char", Field::INT8},
  {"signed_char", Field::INT8},
  {"unsigned_char", Field::UINT8},
  {"short", Field::INT16},
  {"unsigned_short", Field::UINT16},
  {"int", Field::INT32},
  {"vtkIdType", Field::INT32}, // VTK writes its identifiers with 32 bits
  {"unsigned_int", Field::UINT32},
  {"vtktypeint64", Field::INT64},
  {"long", Field::INT64},
  {"vtktypeuint64", Field::UINT64},
  {"unsigned_long", Field::UINT64},
  {"float", Field::FLOAT32},
  {"double", Field::FLOAT64},
}};

} // namespace

const char*
vtkTypeName (ScalarType type)
{
  return std::find_if (types.begin (), types.end (), [type] (const auto& t) { return t.second == type; })
    ->first;
}

ScalarType
VtkValues::readType ()
{
  const std::string_view type = scanner.wordOnLine ();
  const auto known = std::find_if (types.begin (), types.end (), [&] (const auto& t) {
    const std::string_view other = t.first;
    return std::equal (
      type.begin (), type.end (), other.begin (), other.end (),
      [] (unsigned char a, unsigned char b) { return std::tolower (a) == std::tolower (b); });
  });
  if (known == types.end ())
    scanner.failAtWord ("a type of numbers", type);
  return known->second;
}

VtkArray
VtkValues::readTyped (const std::string& name, std::size_t tuples, std::size_t components)
{
  const ScalarType type = readType ();
  return readArray (name, type, tuples, components);
}

VtkArray
VtkValues::readArray (const std::string& name, ScalarType type, std::size_t tuples, std::size_t components)
{
  VtkArray array{name, type, components, {}};
  const std::size_t least = ascii ? 2 : sizeOf (type); // text: a digit and what separates it from the next
  const std::size_t most = (scanner.remaining () + 1) / least;
  if (components > 0 && tuples > most / components)
    scanner.failAtLine ("more values than the file can hold");
  array.data.resize (tuples * components * sizeOf (type));
  if (ascii)
    readText (array, tuples * components);
  else
    readBinary (array, tuples * components);
  return array;
}

void
VtkValues::readText (VtkArray& array, std::size_t values)
{
  withType (array.type, [&] (auto value) {
    for (std::size_t i = 0; i < values; ++i) {
      value = scanner.number<decltype (value)> ();
      std::memcpy (array.data.data () + i * sizeof (value), &value, sizeof (value));
    }
  });
}

void
VtkValues::readBinary (VtkArray& array, std::size_t values)
{
  if (const std::string_view rest = scanner.wordOnLine (); !rest.empty ())
    scanner.failAtWord ("the end of the line", rest);
  scanner.line ();
  const std::string_view bytes = scanner.take (array.data.size ());
  std::copy (bytes.begin (), bytes.end (), array.data.begin ());
  if (!host_is_big_endian)
    swapBytes (array.data.data (), sizeOf (array.type), values);
}

std::vector<std::int64_t>
VtkValues::readIntegers (std::size_t count)
{
  return wholeValues (readArray ("", Field::INT32, count, 1));
}

} // namespace manifold
} // namespace pcl
