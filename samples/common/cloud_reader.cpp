#include "cloud_reader.h"

#include "app_error.h"
#include "coordinates.h"
#include "file_type.h"
#include "input_file.h"
#include "off_reader.h"
#include "pcd_reader.h"
#include "xyz_reader.h"

#include <pcl/manifold/complex_io.h>

#include <sstream>

namespace pcl::manifold::apps {

namespace {

/** \brief The points of a file that may hold a mesh too. */
pcl::PCLPointCloud2
readMeshPoints (const std::string& file)
{
  pcl::PCLPointCloud2 cloud;
  pcl::SimplicialComplex complex;
  std::string error;
  if (!pcl::manifold::loadComplex (file, cloud, complex, error))
    throw AppError (file, error);
  if (cloud.width == 0 || cloud.height == 0)
    throw AppError (file, "holds no point");
  // The names that PCL's point types have.
  for (pcl::PCLPointField& field : cloud.fields)
    if (field.name == "nx" || field.name == "ny" || field.name == "nz")
      field.name = std::string ("normal_") + field.name[1];
  return cloud;
}

/** \brief Does the file lack the first line of every PLY file? */
bool
lacksPlyHeader (const std::string& file)
{
  std::string line;
  InputFile input (file);
  return input.readLine (line) && line != "ply";
}

} // namespace

const char* const cloud_file_types = ".pcd .ply .xyz .txt .off .obj .vtk .vtu";

InputCloud
readCloud (const std::string& file, Reading reading)
{
  InputCloud input;
  input.file = file;
  const std::string type = fileType (file);
  if (type == ".pcd")
    input.cloud = readPcd (file, input.viewpoint);
  else if (type == ".xyz" || type == ".txt" ||
           (type == ".ply" && reading == Reading::LAX && lacksPlyHeader (file)))
    input.cloud = readXyz (file, input.notes);
  else if (type == ".off")
    input.cloud = readOffVertices (file);
  else if (type == ".ply" || type == ".obj" || type == ".vtk" || type == ".vtu")
    input.cloud = readMeshPoints (file);
  else
    throw AppError (file, "unknown type of file; known are " + std::string (cloud_file_types));

  const CoordinateShift shift = makeCoordinatesFloat (input.cloud, file);
  input.origin = shift.origin;
  input.no_measurement = shift.no_measurement;
  if (input.origin != std::array<double, 3>{}) {
    std::ostringstream note;
    note.precision (15);
    note << "coordinates shifted: origin " << input.origin[0] << " " << input.origin[1] << " "
         << input.origin[2] << " subtracted";
    input.notes.push_back (note.str ());
    for (int axis = 0; axis < 3; ++axis)
      input.viewpoint[axis] -= input.origin[axis];
  }
  return input;
}

} // namespace pcl::manifold::apps
