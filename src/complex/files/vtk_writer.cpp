#include "complex/files/formats.h"
#include "complex/files/value_writer.h"
#include "complex/files/vtk_data.h"
#include "complex/files/vtk_values.h"

#include <cctype>

namespace pcl {
namespace manifold {

namespace {

/** \brief A name without blanks and what else VTK takes for the end of one. */
std::string
encodeName (const std::string& name)
{
  constexpr char digits[] = "0123456789ABCDEF";
  std::string word;
  for (const char c : name) {
    const auto code = static_cast<unsigned char> (c);
    if (std::isgraph (code) != 0 && c != '"' && c != '%')
      word += c;
    else
      word += {'%', digits[code / 16], digits[code % 16]};
  }
  return word;
}

class VtkWriter
{
public:
  VtkWriter (OutputFile& file, const CloudFields& cloud, const FileCells& cells, bool ascii)
    : writer_ (file, ascii ? Encoding::TEXT : Encoding::BINARY_BIG), cloud_ (cloud), complex_ (cells.complex),
      polygons_ (cells.polygons)
  {
    writer_.text (std::string ("# vtk DataFile Version 3.0\nwritten by pcl_manifold\n") +
                  (ascii ? "ASCII" : "BINARY") + "\nDATASET UNSTRUCTURED_GRID\n");
  }

  void write ()
  {
    writePoints ();
    writeCells ();
    writeArrays ();
    writer_.finish ();
  }

private:
  void writePoints ()
  {
    const auto xyz = cloud_.coordinates ();
    const ScalarType type = coordinateType (xyz);
    writer_.text ("POINTS " + std::to_string (cloud_.points ()) + " " + vtkTypeName (type) + "\n");
    for (std::size_t i = 0; i < cloud_.points (); ++i) {
      for (const CloudField& field : xyz) {
        const double value = toDouble (field.type, cloud_.point (i) + field.offset);
        if (type == pcl::PCLPointField::FLOAT64)
          writer_.value (value);
        else
          writer_.value (static_cast<float> (value));
      }
      writer_.endRow ();
    }
    writer_.text ("\n");
  }

  void writeRow (const pcl::index_t* begin, const pcl::index_t* end)
  {
    writer_.value (static_cast<std::int32_t> (end - begin));
    for (const pcl::index_t* v = begin; v != end; ++v)
      writer_.value (static_cast<std::int32_t> (*v));
    writer_.endRow ();
  }

  template <std::size_t N>
  void writeRows (const std::vector<std::array<pcl::index_t, N>>& simplices)
  {
    for (const auto& simplex : simplices)
      writeRow (simplex.data (), simplex.data () + N);
  }

  void writeTypes (std::size_t count, VtkCellType type)
  {
    for (std::size_t i = 0; i < count; ++i) {
      writer_.value (static_cast<std::int32_t> (type));
      writer_.endRow ();
    }
  }

  void writeCells ()
  {
    const std::size_t edges = complex_.edges.size (), triangles = complex_.triangles.size (),
                      tetrahedra = complex_.tetrahedra.size (), polygons = polygons_.size ();
    const std::string cells = std::to_string (edges + triangles + tetrahedra + polygons);
    writer_.text (
      "CELLS " + cells + " " +
      std::to_string (3 * edges + 4 * triangles + 5 * tetrahedra + polygons + polygons_.vertices.size ()) +
      "\n");
    writeRows (complex_.edges);
    writeRows (complex_.triangles);
    writeRows (complex_.tetrahedra);
    for (std::size_t f = 0; f < polygons; ++f)
      writeRow (polygons_.vertices.data () + polygons_.starts[f],
                polygons_.vertices.data () + polygons_.starts[f + 1]);
    writer_.text ("\nCELL_TYPES " + cells + "\n");
    writeTypes (edges, VTK_CELL_LINE);
    writeTypes (triangles, VTK_CELL_TRIANGLE);
    writeTypes (tetrahedra, VTK_CELL_TETRA);
    writeTypes (polygons, VTK_CELL_POLYGON);
    writer_.text ("\n");
  }

  void writeArrays ()
  {
    const std::vector<CloudField> fields = cloud_.attributes ();
    if (fields.empty ())
      return;
    const std::string points = std::to_string (cloud_.points ());
    writer_.text ("POINT_DATA " + points + "\nFIELD fields " + std::to_string (fields.size ()) + "\n");
    std::vector<std::uint8_t> values;
    for (const CloudField& field : fields) {
      values.resize (field.size ());
      writer_.text (encodeName (field.name) + " " + std::to_string (field.count) + " " + points + " " +
                    vtkTypeName (field.type) + "\n");
      for (std::size_t i = 0; i < cloud_.points (); ++i) {
        field.copy (cloud_.point (i), values.data ());
        writer_.values (field.type, values.data (), field.count);
        writer_.endRow ();
      }
      writer_.text ("\n");
    }
  }

  ValueWriter writer_;
  const CloudFields& cloud_;
  const SimplicialComplex& complex_;
  const FaceRows& polygons_;
};

} // namespace

void
writeVtk (OutputFile& file, const CloudFields& cloud, const FileCells& cells, bool ascii)
{
  VtkWriter (file, cloud, cells, ascii).write ();
}

} // namespace manifold
} // namespace pcl
