#include "files/formats.h"
#include "files/value_writer.h"

#include <pcl/common/io.h>

#include <functional>

namespace pcl::manifold {

void
writePcd (OutputFile& file, const pcl::PCLPointCloud2& cloud, const Viewpoint& viewpoint)
{
  const pcl::PCLPointCloud2 points = packed (cloud);
  ValueWriter writer (file, Encoding::TEXT);
  writer.text ("# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7");
  const auto writeLine = [&] (const char* keyword,
                              const std::function<std::string (const PCLPointField&)>& entry) {
    writer.text (keyword);
    for (const pcl::PCLPointField& field : points.fields)
      writer.text (" " + entry (field));
  };
  writeLine ("\nFIELDS", [] (const PCLPointField& field) { return field.name; });
  writeLine ("\nSIZE", [] (const PCLPointField& field) { return std::to_string (sizeOf (field.datatype)); });
  writeLine ("\nTYPE", [] (const PCLPointField& field) {
    return std::string (1, pcl::getFieldType (static_cast<int> (field.datatype)));
  });
  writeLine ("\nCOUNT", [] (const PCLPointField& field) { return std::to_string (field.count); });
  const std::size_t size = static_cast<std::size_t> (points.width) * points.height;
  writer.text ("\nWIDTH " + std::to_string (points.width) + "\nHEIGHT " + std::to_string (points.height) +
               "\nVIEWPOINT ");
  for (const double value : viewpoint)
    writer.value (value);
  writer.text ("\nPOINTS " + std::to_string (size) + "\nDATA binary\n");
  writer.finish ();
  file.write ({reinterpret_cast<const char*> (points.data.data ()), points.data.size ()});
}

} // namespace pcl::manifold
