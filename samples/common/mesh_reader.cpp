#include "mesh_reader.h"

#include "app_error.h"
#include "complex_layers.h"
#include "coordinates.h"
#include "file_type.h"

#include <pcl/conversions.h>
#include <pcl/manifold/complex_io.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cmath>

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

const char* const mesh_file_types = ".ply .obj .vtk .vtu";

InputMesh
readMesh (const std::string& file, const InputCloud& cloud)
{
  const std::string type = fileType (file);
  if (type != ".ply" && type != ".obj" && type != ".vtk" && type != ".vtu")
    throw AppError (file, std::string ("unknown type of mesh; known are ") + mesh_file_types);
  InputMesh mesh;
  std::string error;
  if (!pcl::manifold::loadComplex (file, mesh.cloud, mesh.complex, error))
    throw AppError (file, error);
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
  return mesh;
}

} // namespace pcl::manifold::apps
