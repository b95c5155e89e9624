#include "mesh_reader.h"

#include "app_error.h"
#include "complex_layers.h"
#include "coordinates.h"

#include <pcl/conversions.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cmath>
#include <utility>

namespace pcl::manifold::apps {
namespace {

/** \brief Subtracts an offset from x, y and z, which are floats. */
void
shift (pcl::PCLPointCloud2& cloud, const std::array<double, 3>& offset)
{
  pcl::PointCloud<pcl::PointXYZ> points;
  pcl::fromPCLPointCloud2 (cloud, points);
  for (pcl::PointXYZ& point : points)
    for (int axis = 0; axis < 3; ++axis)
      point.data[axis] = static_cast<float> (point.data[axis] - offset[axis]);
  pcl::toPCLPointCloud2 (points, cloud);
}

/** \brief Throws unless all points of simplices are finite. */
template <typename Simplices>
void
checkPoints (const std::string& file, const Positions& positions, const Simplices& simplices)
{
  for (const auto& simplex : simplices)
    for (const pcl::index_t vertex : simplex)
      for (const float value : positions[static_cast<std::size_t> (vertex)])
        if (!std::isfinite (value))
          throw AppError (file, "point " + std::to_string (vertex) + ", of a face, is not finite");
}

} // namespace

const char* const mesh_file_types = ".ply .obj";

InputMesh
readMesh (const std::string& file, const InputCloud& cloud)
{
  FileContent mesh = readFile (file, mesh_file_types);
  if (mesh.complex.triangles.empty () && mesh.complex.tetrahedra.empty ())
    throw AppError (file, "holds no face");
  std::array<double, 3> offset = makeCoordinatesFloat (mesh.cloud, file).origin;
  if (offset != std::array<double, 3>{}) {
    for (int axis = 0; axis < 3; ++axis)
      offset[axis] = cloud.origin[axis] - offset[axis];
    shift (mesh.cloud, offset);
  }
  const auto positions = positionsOf (mesh.cloud);
  checkPoints (file, *positions, mesh.complex.triangles);
  checkPoints (file, *positions, mesh.complex.tetrahedra);
  return {std::move (mesh.cloud), std::move (mesh.complex)};
}

} // namespace pcl::manifold::apps
