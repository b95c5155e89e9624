#include "files/file_error.h"
#include "files/formats.h"
#include "files/ply_header.h"
#include "files/value_writer.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <set>

namespace pcl::manifold {
namespace {

using Field = pcl::PCLPointField;

bool
is64Bit (ScalarType type)
{
  return type == Field::INT64 || type == Field::UINT64;
}

/** \brief The names of a field's properties: one, or one a colour channel. */
std::vector<std::string>
propertyNames (const CloudField& field)
{
  if (!field.packed_color)
    return {field.name};
  const std::vector<std::string> channels = {"red", "green", "blue", "alpha"};
  return {channels.begin (), channels.begin () + static_cast<std::ptrdiff_t> (field.count)};
}

/** \brief PLY separates by blanks and knows a property by its name. */
void
checkNames (const CloudFields& cloud)
{
  std::set<std::string> names;
  for (const CloudField& field : cloud.fields ())
    for (const std::string& name : propertyNames (field)) {
      if (std::any_of (name.begin (), name.end (), [] (unsigned char c) { return !std::isgraph (c); }))
        throw FileError ("PLY cannot write the field '" + name + "': its name has blanks or such in it");
      if (!names.insert (name).second)
        throw FileError ("PLY cannot write two fields " + name);
    }
}

std::string
headerOf (const CloudFields& cloud, std::size_t edges, std::size_t faces, bool long_faces, bool ascii)
{
  std::string header = "ply\nformat ";
  header += ascii ? "ascii" : "binary_little_endian";
  header += " 1.0\ncomment written by pcl_manifold\n";
  if (cloud.rows () > 1) // as PCL writes and reads it
    header += "obj_info num_cols " + std::to_string (cloud.points () / cloud.rows ()) +
              "\nobj_info num_rows " + std::to_string (cloud.rows ()) + "\n";
  header += "element vertex " + std::to_string (cloud.points ()) + "\n";
  for (const CloudField& field : cloud.fields ())
    for (const std::string& name : propertyNames (field)) {
      const bool is_list = field.count > 1 && !field.packed_color;
      header += std::string (is_list ? "property list uint " : "property ") + plyTypeName (field.type) + " " +
                name + "\n";
    }
  if (edges > 0)
    header += "element edge " + std::to_string (edges) + "\nproperty int vertex1\nproperty int vertex2\n";
  return header + "element face " + std::to_string (faces) + "\nproperty list " +
         (long_faces ? "uint" : "uchar") + " int vertex_indices\nend_header\n";
}

/** \brief An integer of 64 bits as a double. */
double
wideValue (const CloudField& field, const std::uint8_t* data)
{
  return withType (field.type, [&] (auto value) {
    std::memcpy (&value, data, sizeof (value));
    const auto wide = static_cast<double> (value);
    // 2^63 and 2^64 are beyond the types' ranges, so that casting them back would be undefined.
    if (std::abs (wide) >= 9.2e18 || static_cast<decltype (value)> (wide) != value)
      throw FileError ("PLY has no 64-bit integers and cannot write the " + std::to_string (value) +
                       " of the field " + field.name + "; write VTU");
    return wide;
  });
}

/** \brief Writes one face after the other, with the length that the header announces. */
class FaceWriter
{
public:
  FaceWriter (ValueWriter& writer, bool long_faces) : writer_ (writer), long_faces_ (long_faces) {}

  void write (const pcl::index_t* begin, const pcl::index_t* end)
  {
    if (long_faces_)
      writer_.value (static_cast<std::uint32_t> (end - begin));
    else
      writer_.value (static_cast<std::uint8_t> (end - begin));
    for (const pcl::index_t* v = begin; v != end; ++v)
      writer_.value (static_cast<std::int32_t> (*v));
    writer_.endRow ();
  }

  void write (const std::vector<SimplicialComplex::Triangle>& triangles)
  {
    for (const SimplicialComplex::Triangle& t : triangles)
      write (t.data (), t.data () + t.size ());
  }

  void write (const FaceRows& faces)
  {
    for (std::size_t f = 0; f < faces.size (); ++f)
      write (faces.vertices.data () + faces.starts[f], faces.vertices.data () + faces.starts[f + 1]);
  }

private:
  ValueWriter& writer_;
  const bool long_faces_;
};

/** \brief Whether a face has more vertices than a byte can count. */
bool
hasLongFaces (const FaceRows& faces)
{
  for (std::size_t f = 0; f < faces.size (); ++f)
    if (faces.starts[f + 1] - faces.starts[f] > std::numeric_limits<std::uint8_t>::max ())
      return true;
  return false;
}

} // namespace

void
writePly (OutputFile& file, const CloudFields& cloud, const FileCells& cells, bool ascii)
{
  checkNames (cloud);
  const std::vector<SimplicialComplex::Triangle> boundary = boundaryTriangles (cells.complex.tetrahedra);
  const bool long_faces = hasLongFaces (cells.polygons);
  ValueWriter writer (file, ascii ? Encoding::TEXT : Encoding::BINARY_LITTLE);
  writer.text (headerOf (cloud, cells.complex.edges.size (),
                         cells.complex.triangles.size () + boundary.size () + cells.polygons.size (),
                         long_faces, ascii));
  std::vector<std::uint8_t> values;
  for (std::size_t i = 0; i < cloud.points (); ++i) {
    for (const CloudField& field : cloud.fields ()) {
      values.resize (field.size ());
      field.copy (cloud.point (i), values.data ());
      if (field.count > 1 && !field.packed_color)
        writer.value (static_cast<std::uint32_t> (field.count));
      if (!is64Bit (field.type))
        writer.values (field.type, values.data (), field.count);
      else
        for (std::size_t k = 0; k < field.count; ++k)
          writer.value (wideValue (field, values.data () + k * sizeOf (field.type)));
    }
    writer.endRow ();
  }
  for (const SimplicialComplex::Edge& edge : cells.complex.edges) {
    writer.value (static_cast<std::int32_t> (edge[0]));
    writer.value (static_cast<std::int32_t> (edge[1]));
    writer.endRow ();
  }
  FaceWriter faces (writer, long_faces);
  faces.write (cells.complex.triangles);
  faces.write (boundary);
  faces.write (cells.polygons);
  writer.finish ();
}

} // namespace pcl::manifold
