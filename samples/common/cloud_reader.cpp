#include "cloud_reader.h"

#include "app_files.h"
#include "coordinates.h"

#include "files/input_file.h"
#include "files/scanner.h"

#include <algorithm>
#include <iterator>
#include <sstream>

namespace pcl::manifold::apps {

namespace {

struct Format
{
  const char* type;
  FileContent (*read) (std::string_view);
};

constexpr Format formats[] = {{".pcd", readPcd},  {".ply", readPly}, {".xyz", readText},
                              {".txt", readText}, {".off", readOff}, {".obj", readObj}};

} // namespace

const char* const cloud_file_types = ".pcd .ply .xyz .txt .off .obj";

FileContent
readFile (const std::string& file, const std::string& types, Reading reading)
{
  const std::string type = fileType (file);
  const Format* const format =
    std::find_if (std::begin (formats), std::end (formats), [&] (const Format& f) { return f.type == type; });
  if (format == std::end (formats) || (types + " ").find (type + " ") == std::string::npos)
    throw AppError (file, "unknown type of file; known are " + types);
  return about (file, [&] {
    const InputFile input (file);
    if (input.bytes ().empty ())
      throw FileError ("the file is empty");
    const bool headless =
      reading == Reading::LAX && type == ".ply" && Scanner (input.bytes ()).wordOnLine () != "ply";
    FileContent content = headless ? readText (input.bytes ()) : format->read (input.bytes ());
    if (content.cloud.width == 0 || content.cloud.height == 0)
      throw FileError ("holds no point");
    return content;
  });
}

InputCloud
readCloud (const std::string& file, Reading reading)
{
  InputCloud input{readFile (file, cloud_file_types, reading), file, {}, 0};
  // The names that PCL's point types have.
  if (fileType (file) == ".ply")
    for (pcl::PCLPointField& field : input.cloud.fields)
      if (field.name == "nx" || field.name == "ny" || field.name == "nz")
        field.name = std::string ("normal_") + field.name[1];
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
