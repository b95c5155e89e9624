#include <pcl/manifold/complex_io.h>

#include "files/file_error.h"
#include "files/formats.h"
#include "files/input_file.h"
#include "files/output_file.h"

#include <algorithm>
#include <iterator>
#include <new>
#include <utility>

namespace pcl {
namespace manifold {

namespace {

struct Format
{
  const char* extension;
  FileContent (*read) (std::string_view); ///< nullptr for what is written only
  void (*write) (OutputFile&, const CloudFields&, const FileCells&, bool);
};

constexpr Format formats[] = {
  {".ply", readPly, writePly},
  {".obj", readObj, writeObj},
  {".vtk", nullptr, writeVtk},
  {".vtu", nullptr, writeVtu},
};

/** \throw FileError with what to use instead, if the file has none of the extensions, or it cannot be read */
const Format&
formatOf (const std::string& file, bool reading)
{
  const std::string extension = fileType (file);
  const Format* const format = std::find_if (std::begin (formats), std::end (formats),
                                             [&] (const Format& f) { return extension == f.extension; });
  if (format != std::end (formats) && (format->read != nullptr || !reading))
    return *format;
  throw FileError ((extension.empty ()             ? "no extension"
                    : format == std::end (formats) ? "unknown extension " + extension
                                                   : extension + " is written only") +
                   (reading ? "; use .ply or .obj" : "; use .ply, .obj, .vtk or .vtu"));
}

/** \brief Runs something that may fail and puts why it did into one line. */
template <typename Function>
bool
succeeds (Function function, std::string& error)
{
  error.clear ();
  try {
    function ();
    return true;
  } catch (const std::bad_alloc&) {
    error = "not enough memory";
  } catch (const std::exception& exception) {
    error = exception.what ();
  }
  return false;
}

/** \brief Tells polygons of two vertices, edges, from larger ones. \throw FileError for one that is neither
 */
void
sortPolygons (const std::vector<pcl::Vertices>& polygons, std::size_t points, SimplicialComplex& edges,
              FaceRows& faces)
{
  for (std::size_t i = 0; i < polygons.size (); ++i) {
    const pcl::Indices& vertices = polygons[i].vertices;
    const auto number = [i] { return "polygon " + std::to_string (i); };
    if (vertices.size () < 2)
      throw FileError (number () + " has " + std::to_string (vertices.size ()) + " vertices");
    for (const pcl::index_t v : vertices)
      if (v < 0 || static_cast<std::size_t> (v) >= points)
        throw FileError (number () + " has vertex " + std::to_string (v) + ", but there are " +
                         std::to_string (points) + " points");
    if (vertices.size () == 2) {
      edges.edges.push_back ({vertices[0], vertices[1]});
    } else {
      faces.vertices.insert (faces.vertices.end (), vertices.begin (), vertices.end ());
      faces.starts.push_back (faces.vertices.size ());
    }
  }
}

} // namespace

bool
canSaveComplex (const std::string& file, std::string& error)
{
  return succeeds (
    [&] {
      formatOf (file, false);
      // Whether the folder can be written to is not told by its permissions alone: try.
      OutputFile probe (file);
    },
    error);
}

bool
saveComplex (const std::string& file, const pcl::PCLPointCloud2& cloud, const SimplicialComplex& complex,
             std::string& error, bool ascii)
{
  return succeeds (
    [&] {
      const Format& format = formatOf (file, false);
      const CloudFields fields (cloud);
      std::string why;
      if (!isValid (complex, fields.points (), &why))
        throw FileError (why);
      OutputFile output (file);
      format.write (output, fields, {complex, FaceRows ()}, ascii);
      output.commit ();
    },
    error);
}

bool
savePolygonMesh (const std::string& file, const pcl::PolygonMesh& mesh, std::string& error, bool ascii)
{
  return succeeds (
    [&] {
      const Format& format = formatOf (file, false);
      const CloudFields fields (mesh.cloud);
      SimplicialComplex edges;
      FaceRows faces;
      sortPolygons (mesh.polygons, fields.points (), edges, faces);
      OutputFile output (file);
      format.write (output, fields, {edges, faces}, ascii);
      output.commit ();
    },
    error);
}

bool
loadComplex (const std::string& file, pcl::PCLPointCloud2& cloud, SimplicialComplex& complex,
             std::string& error)
{
  FileContent content;
  const bool loaded = succeeds (
    [&] {
      const Format& format = formatOf (file, true);
      content = format.read (InputFile (file).bytes ());
    },
    error);
  if (!loaded)
    content = FileContent ();
  cloud = std::move (content.cloud);
  complex = std::move (content.complex);
  return loaded;
}

} // namespace manifold
} // namespace pcl
