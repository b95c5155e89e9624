#include "dimension_clouds.h"

#include "../test_must_show_models.h"

#include <app_error.h>
#include <files/cloud_fields.h>
#include <generate/lidar_sweeps.h>
#include <generate/scenes.h>
#include <sample_input.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

namespace evaluate {

namespace {

// Farther away the beams of a frame are too far apart to tell a pole.
constexpr double FRAME_RANGE = 25.0;

LabelledPoints
labelled (const generate::LabelledCloud& cloud)
{
  LabelledPoints result;
  result.points = must_show::pointsOf (cloud);
  result.dimension.assign (cloud.labels.begin (), cloud.labels.end ());
  result.classes = cloud.object;
  for (const std::uint32_t label : cloud.labels)
    result.curve.push_back (label == 1 ? Curve::YES : Curve::NO);
  return result;
}

// Of a street: trunks are surfaces near by and curves from afar.
LabelledPoints
labelledStreet (const generate::LabelledCloud& cloud, double range)
{
  LabelledPoints result = labelled (cloud);
  for (std::size_t i = 0; i < cloud.size (); ++i) {
    const bool trunk = cloud.object[i] == static_cast<std::uint32_t> (generate::LidarClass::VEGETATION) &&
                       cloud.labels[i] == 2;
    if (trunk || cloud.points[i].norm () > range)
      result.curve[i] = Curve::NOT_ASKED;
  }
  return result;
}

LabelledPoints
readLabelled (const std::string& file, const std::vector<std::uint32_t>& curves)
{
  using namespace pcl::manifold;
  const apps::InputCloud input = apps::readCloud (file);
  const CloudFields fields (input.cloud);
  const auto label = std::find_if (fields.fields ().begin (), fields.fields ().end (),
                                   [] (const CloudField& field) { return field.name == "label"; });
  if (label == fields.fields ().end () || label->size () != sizeof (std::uint32_t))
    throw apps::AppError (file, "has no field label of 4 bytes");
  LabelledPoints result;
  result.points = apps::pointsOf (input)->getMatrixXfMap (3, 4, 0).cast<double> ();
  for (std::size_t i = 0; i < fields.points (); ++i) {
    std::uint32_t value = 0;
    label->copy (fields.point (i), reinterpret_cast<std::uint8_t*> (&value));
    const bool is_curve = std::find (curves.begin (), curves.end (), value) != curves.end ();
    result.curve.push_back (is_curve ? Curve::YES : Curve::NO);
    result.classes.push_back (value);
  }
  return result;
}

struct LabelledFile
{
  const char* name;
  std::vector<std::uint32_t> curves; ///< the labels of what is one
  bool vertical;
};

} // namespace

std::vector<DimensionCloud>
generatedClouds (int seeds)
{
  std::vector<DimensionCloud> clouds;
  for (int i = 1; i <= seeds; ++i) {
    const auto seed = static_cast<std::uint64_t> (i);
    const std::string suffix = seeds > 1 ? ", seed " + std::to_string (i) : "";
    const auto add = [&] (const std::string& name, std::function<LabelledPoints ()> make) {
      clouds.push_back ({name + suffix, std::move (make)});
    };
    for (const char* const spacing : {"0.04", "0.12"})
      add (std::string ("scene, blue ") + spacing,
           [=] { return labelled (generate::mixedScene (std::stod (spacing), seed)); });
    add ("scene, random", [=] { return labelled (generate::mixedSceneRandom (20000, seed)); });
    for (const char* const noise : {"0.01", "0.02"})
      add (std::string ("scene, noise ") + noise, [=] {
        generate::LabelledCloud cloud = generate::mixedScene (0.04, seed);
        generate::addNoise (cloud, std::stod (noise), seed + 1000);
        return labelled (cloud);
      });
    for (const generate::LidarSweep& sweep : generate::lidarSweeps ())
      add (sweep.name, [=] {
        const bool map = sweep.name.rfind ("map", 0) == 0, frame = sweep.name.rfind ("frame", 0) == 0;
        generate::LidarSettings settings;
        settings.points = map ? 400000 : sweep.usual_points;
        settings.seed = seed;
        const generate::LabelledCloud cloud = sweep.make (settings, {});
        return map || frame ? labelledStreet (cloud, frame ? FRAME_RANGE : 1e300) : labelled (cloud);
      });
  }
  return clouds;
}

std::vector<DimensionCloud>
labelledFiles (const std::string& folder)
{
  // Poles and signs; wires.
  const std::vector<LabelledFile> files = {{"kitti00_000000_front.pcd", {80, 81}, true},
                                           {"kitti00_map_pole_wall.pcd", {80, 81}, true},
                                           {"ahn_mini.pcd", {14}, false},
                                           {"ahn_12AN2_20.pcd", {14}, false}};
  std::vector<DimensionCloud> clouds;
  for (const LabelledFile& file : files) {
    const std::string path = (std::filesystem::path (folder) / file.name).string ();
    if (!std::filesystem::exists (path)) {
      std::printf ("%s is not there\n", path.c_str ());
      continue;
    }
    clouds.push_back (
      {file.name, [path, curves = file.curves] { return readLabelled (path, curves); }, file.vertical});
  }
  return clouds;
}

} // namespace evaluate
