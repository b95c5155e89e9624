#include "app_error.h"
#include "app_files.h"
#include "app_main.h"
#include "complex_layers.h"
#include "files/cloud_fields.h"
#include "files/number_text.h"
#include "picture.h"
#include "progress.h"
#include "report.h"
#include "table.h"

#include <generate/catalogue.h>
#include <generate/labelled_cloud.h>
#include <generate/lidar.h>
#include <generate/lidar_sweeps.h>
#include <generate/sampling.h>
#include <generate/scenes.h>

#include <pcl/PCLPointField.h>

#include <algorithm>
#include <iomanip>
#include <iostream>
#include <string_view>

using namespace pcl::manifold;
using namespace pcl::manifold::apps;

namespace {

const std::string SCENE = "scene";
constexpr double MOST_POINTS = 2e7;

/** What the user asked for. */
struct Request
{
  std::string shape, file;
  std::uint64_t points = 0; ///< 0: as many as is usual for the shape
  double spacing = 0.0;     ///< 0: from the number of points
  std::string sampling = "auto";
  std::string noise = "auto";
  std::uint64_t seed = 1;
};

/** The lidar of that name, or nullptr. */
const generate::LidarSweep*
lidarOf (const Request& request)
{
  for (const generate::LidarSweep& lidar : generate::lidarSweeps ())
    if (lidar.name == request.shape)
      return &lidar;
  return nullptr;
}

/** Puts the usual values in place of those that were not given; refuses what does not go together. */
Request
completed (Request request)
{
  const std::vector<std::string>& names = generate::shapeNames ();
  const generate::LidarSweep* const lidar = lidarOf (request);
  if (lidar == nullptr && request.shape != SCENE &&
      std::find (names.begin (), names.end (), request.shape) == names.end ())
    throw UsageError ("SHAPE", "there is no shape '" + request.shape + "', see -list");
  requireType ("OUT", request.file, {".pcd"});

  if (request.sampling == "auto")
    request.sampling = lidar != nullptr ? "lidar" : "blue";
  if (request.sampling != "blue" && request.sampling != "random" && request.sampling != "lidar")
    throw UsageError ("-sampling", "'" + request.sampling + "' is none of blue, random, lidar");
  if ((lidar != nullptr) != (request.sampling == "lidar"))
    throw UsageError ("-sampling", "'" + request.sampling + "' does not go with " + request.shape);

  if (request.spacing > 0.0 && request.points > 0)
    throw UsageError ("-spacing", "does not go together with -n");
  if (request.spacing > 0.0 && request.sampling != "blue")
    throw UsageError ("-spacing", "goes with blue noise only");
  if (request.spacing == 0.0 && request.points == 0)
    request.points = lidar != nullptr ? lidar->usual_points : 10000;

  if (request.noise == "auto")
    request.noise = lidar != nullptr ? "0.02" : "0";
  return request;
}

double
noiseOf (const Request& request)
{
  double noise = 0.0;
  if (!parseNumber (std::string_view (request.noise), noise) || !(noise >= 0.0 && noise <= 1e300))
    throw UsageError ("-noise", "'" + request.noise + "' is no number of at least 0");
  return noise;
}

/** The spacing of blue noise, asked for or from the number of points. */
double
spacingOf (const Request& request, const std::vector<generate::Shape>& shapes)
{
  const double spacing =
    request.spacing > 0.0 ? request.spacing : generate::spacingFor (shapes.front (), request.points);
  double expected = 0.0;
  for (const generate::Shape& shape : shapes)
    expected += generate::expectedCount (shape, spacing);
  if (!(expected <= MOST_POINTS))
    throw UsageError (request.spacing > 0.0 ? "-spacing" : "-n", "gives more than 20 000 000 points");
  return spacing;
}

generate::LabelledCloud
makeCloud (const Request& request, const generate::Tick& tick, Report& report)
{
  if (const generate::LidarSweep* const lidar = lidarOf (request)) {
    generate::LidarSettings settings;
    settings.points = request.points;
    settings.range_noise = noiseOf (request);
    settings.seed = request.seed;
    return lidar->make (settings, tick);
  }
  const bool is_scene = request.shape == SCENE;
  const std::vector<generate::Shape> shapes =
    is_scene ? generate::mixedSceneShapes () : std::vector{generate::shapeByName (request.shape)};
  generate::LabelledCloud cloud;
  if (request.sampling == "random") {
    cloud = is_scene ? generate::mixedSceneRandom (request.points, request.seed)
                     : generate::uniform (shapes.front (), request.points, request.seed);
  } else {
    const double spacing = spacingOf (request, shapes);
    report.parameter ("spacing", spacing);
    cloud = is_scene
              ? generate::mixedScene (spacing, request.seed, tick)
              : generate::blueNoise (shapes.front (), spacing, request.seed, generate::Strata::SAMPLED, tick);
  }
  // Another seed, or the noise would follow the points.
  generate::addNoise (cloud, noiseOf (request), request.seed + 0x9E3779B97F4A7C15ULL);
  return cloud;
}

pcl::PCLPointCloud2
toMessage (const generate::LabelledCloud& cloud)
{
  std::vector<float> axis (cloud.size ());
  pcl::PCLPointCloud2 message;
  message.width = static_cast<std::uint32_t> (cloud.size ());
  message.height = 1;
  message.is_dense = 1;
  for (const int i : {0, 1, 2}) {
    std::transform (cloud.points.begin (), cloud.points.end (), axis.begin (),
                    [i] (const Eigen::Vector3d& point) { return static_cast<float> (point[i]); });
    setField (message, std::string (1, "xyz"[i]), axis);
  }
  setField (message, "label", cloud.labels);
  return message;
}

void
describe (const generate::LabelledCloud& cloud, Report& report, Table& table)
{
  static const char* const KINDS[] = {"", "curve", "surface", "solid"};
  report.result ("points", Json::UInt64 (cloud.size ()));
  table.row ("points", cloud.size ());
  for (const std::uint32_t label : {1U, 2U, 3U}) {
    const auto count =
      static_cast<std::size_t> (std::count (cloud.labels.begin (), cloud.labels.end (), label));
    report.result (KINDS[label], Json::UInt64 (count));
    table.row (std::string ("  label ") + std::to_string (label) + ", " + KINDS[label], count);
  }
}

void
printList ()
{
  const auto print = [] (const std::string& name, const std::string& dimension, const std::string& euler) {
    std::cout << "  " << std::left << std::setw (20) << name << std::setw (11) << dimension << euler << '\n';
  };
  print ("shape", "dimension", "Euler characteristic");
  for (const std::string& name : generate::shapeNames ()) {
    const generate::Shape shape = generate::shapeByName (name);
    print (name, std::to_string (shape.dimension), std::to_string (shape.topology.euler));
  }
  print (SCENE, "1, 2, 3", "2 and 0 (sphere, torus), 0 (trefoil), 1 (ball)");
  for (const generate::LidarSweep& lidar : generate::lidarSweeps ())
    print (lidar.name, "1, 2, 3", "-");
}

} // namespace

int
main (int argc, char** argv)
{
  CommandLine command_line (
    "generate_cloud",
    "Makes a synthetic cloud whose shape is known. The field label holds the true dimension of the manifold "
    "that\n"
    "each point lies on: 1 curve, 2 surface, 3 solid. The same options give the same cloud.\n"
    "One thread makes it, whatever -threads says.");
  Request asked;
  CommonOptions common;
  bool list = false;
  command_line
    .positional ("SHAPE", "what to sample: a shape, scene, lidar-aerial, frame-64, ...; see -list",
                 asked.shape)
    .positional ("OUTPUT", "the cloud, fields x y z label: .pcd", asked.file)
    .option ("n", "points",
             "about how many points (of the scene: on its sphere).\n"
             "0 = 10 000, 200 000 for lidar-*, as the sensor turns for frame-* and map-*",
             asked.points, {0, MOST_POINTS})
    .option ("spacing", "h", "smallest distance of blue noise, instead of -n; 0 = from -n", asked.spacing,
             {0, 1e300})
    .option ("sampling", "kind",
             "blue: evenly, no two points near and no gap; random: independent points, rims and skins\n"
             "as dense as the rest;\n"
             "lidar: a sweep with occlusion; auto: lidar for lidar-*, frame-* and map-*, blue for all else",
             asked.sampling)
    .option ("noise", "s",
             "standard deviation of Gaussian noise (of lidar: of the range, in metres).\n"
             "auto: 0, and 0.02 for lidar",
             asked.noise)
    .option ("seed", "n", "of the random numbers", asked.seed)
    .flag ("list", "list the shapes, with dimension and Euler characteristic", list)
    .common (common)
    .example ("generate_cloud torus torus.pcd -spacing 0.05")
    .example ("generate_cloud scene scene.pcd -sampling random -n 60000 -noise 0.01 -seed 7")
    .example ("generate_cloud lidar-aerial village.pcd -picture village.png");
  if (argc == 2 && (std::string (argv[1]) == "-list" || std::string (argv[1]) == "--list")) {
    printList ();
    return 0;
  }

  return runApp (argc, argv, command_line, [&] {
    if (list)
      throw UsageError ("-list", "goes alone");
    const Request request = completed (asked);
    const double noise = noiseOf (request);
    checkWritable (request.file);
    if (!common.report.empty ())
      checkWritable (common.report);
    const Picture picture (common.picture);

    Report report ("generate_cloud");
    report.input ("shape", request.shape);
    report.parameter ("sampling", request.sampling);
    report.parameter ("n", Json::UInt64 (request.points));
    report.parameter ("noise", noise);
    report.parameter ("seed", Json::UInt64 (request.seed));
    generate::LabelledCloud cloud;
    {
      const StageTimer timer (report, "generate");
      Progress progress (request.shape, common.quiet);
      const auto tick = [&] (double fraction) {
        if (!progress.update (static_cast<float> (fraction)))
          throw AppError (request.file, "cancelled");
      };
      cloud = makeCloud (request, tick, report);
      tick (1.0);
    }
    Table table;
    describe (cloud, report, table);

    const pcl::PCLPointCloud2 message = toMessage (cloud);
    const std::vector<std::uint8_t> labels (cloud.labels.begin (), cloud.labels.end ());
    picture.draw (request.shape, {{"true dimension", layersByDimension (positionsOf (message), labels)}});
    writePcd (request.file, message);
    report.finish (common, table);
  });
}
