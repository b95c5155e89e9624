#include "cloud_writer.h"

#include "cloud_fields.h"
#include "output_stream.h"

#include <pcl/io/pcd_io.h>

#include <Eigen/Geometry>

void
pcl::manifold::apps::writePcd (const std::string& file, const pcl::PCLPointCloud2& cloud,
                               const std::array<double, 7>& viewpoint)
{
  const pcl::PCLPointCloud2 points = packed (cloud);
  const std::array<float, 7> view = {static_cast<float> (viewpoint[0]), static_cast<float> (viewpoint[1]),
                                     static_cast<float> (viewpoint[2]), static_cast<float> (viewpoint[3]),
                                     static_cast<float> (viewpoint[4]), static_cast<float> (viewpoint[5]),
                                     static_cast<float> (viewpoint[6])};
  // The header is PCL's own; its writer maps the file into memory, where a full disk is a signal, not an
  // error.
  const std::string header =
    pcl::PCDWriter ().generateHeaderBinary (points, Eigen::Vector4f (view[0], view[1], view[2], 0),
                                            Eigen::Quaternionf (view[3], view[4], view[5], view[6]));
  writeStream (file, [&] (std::ostream& stream) {
    stream << header << "DATA binary\n";
    stream.write (reinterpret_cast<const char*> (points.data.data ()),
                  static_cast<std::streamsize> (points.data.size ()));
  });
}
