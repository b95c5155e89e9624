#include "files/vtk_common.h"

#include <cctype>

namespace pcl::manifold {
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

void
writeCells (ValueWriter& writer, const FileCells& cells)
{
  const std::string count = std::to_string (countCells (cells));
  writer.text ("CELLS " + count + " " + std::to_string (countCells (cells) + countCorners (cells)) + "\n");
  forEachCell (cells, [&] (VtkCellType, const pcl::index_t* begin, const pcl::index_t* end) {
    writer.value (static_cast<std::int32_t> (end - begin));
    for (const pcl::index_t* v = begin; v != end; ++v)
      writer.value (static_cast<std::int32_t> (*v));
    writer.endRow ();
  });
  writer.text ("\nCELL_TYPES " + count + "\n");
  forEachCell (cells, [&] (VtkCellType type, const pcl::index_t*, const pcl::index_t*) {
    writer.value (static_cast<std::int32_t> (type));
    writer.endRow ();
  });
  writer.text ("\n");
}

} // namespace

void
writeVtk (OutputFile& file, const CloudFields& cloud, const FileCells& cells, bool ascii)
{
  ValueWriter writer (file, ascii ? Encoding::TEXT : Encoding::BINARY_BIG);
  const std::string points = std::to_string (cloud.points ());
  writer.text (std::string ("# vtk DataFile Version 3.0\nwritten by pcl_manifold\n") +
               (ascii ? "ASCII" : "BINARY") + "\nDATASET UNSTRUCTURED_GRID\nPOINTS " + points + " " +
               vtkTypeNames (coordinateType (cloud)).legacy + "\n");
  writeCoordinates (writer, cloud);
  writer.text ("\n");
  writeCells (writer, cells);
  const std::vector<CloudField> fields = cloud.attributes ();
  if (!fields.empty ())
    writer.text ("POINT_DATA " + points + "\nFIELD fields " + std::to_string (fields.size ()) + "\n");
  for (const CloudField& field : fields) {
    writer.text (encodeName (field.name) + " " + std::to_string (field.count) + " " + points + " " +
                 vtkTypeNames (field.type).legacy + "\n");
    writeField (writer, cloud, field);
    writer.text ("\n");
  }
  writer.finish ();
}

} // namespace pcl::manifold
