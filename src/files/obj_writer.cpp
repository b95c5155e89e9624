#include "files/formats.h"
#include "files/value_writer.h"

namespace pcl::manifold {
namespace {

void
writeRow (ValueWriter& writer, const char* keyword, const pcl::index_t* begin, const pcl::index_t* end)
{
  writer.text (keyword);
  for (const pcl::index_t* v = begin; v != end; ++v)
    writer.value (static_cast<std::int64_t> (*v) + 1);
  writer.endRow ();
}

template <std::size_t N>
void
writeRows (ValueWriter& writer, const char* keyword,
           const std::vector<std::array<pcl::index_t, N>>& simplices)
{
  for (const auto& simplex : simplices)
    writeRow (writer, keyword, simplex.data (), simplex.data () + N);
}

} // namespace

void
writeObj (OutputFile& file, const CloudFields& cloud, const FileCells& cells, bool /* always text */)
{
  ValueWriter writer (file, Encoding::TEXT);
  writer.text ("# written by pcl_manifold\n");
  const auto xyz = cloud.coordinates ();
  for (std::size_t i = 0; i < cloud.points (); ++i) {
    writer.text ("v ");
    for (const CloudField& field : xyz)
      writer.values (field.type, cloud.point (i) + field.offset, 1);
    writer.endRow ();
  }
  writeRows (writer, "l ", cells.complex.edges);
  writeRows (writer, "f ", cells.complex.triangles);
  writeRows (writer, "f ", boundaryTriangles (cells.complex.tetrahedra));
  const FaceRows& polygons = cells.polygons;
  for (std::size_t f = 0; f < polygons.size (); ++f)
    writeRow (writer, "f ", polygons.vertices.data () + polygons.starts[f],
              polygons.vertices.data () + polygons.starts[f + 1]);
  writer.finish ();
}

} // namespace pcl::manifold
