#include "app_files.h"
#include "app_main.h"
#include "complex_layers.h"
#include "files/cloud_fields.h"
#include "picture.h"
#include "progress.h"
#include "sample_input.h"

#include <pcl/manifold/dimension_detection.h>

#include <algorithm>

using namespace pcl::manifold;
using namespace pcl::manifold::apps;

namespace {

std::size_t
countOf (const std::vector<std::uint8_t>& labels, int label)
{
  return static_cast<std::size_t> (std::count (labels.begin (), labels.end (), label));
}

/** \return the counts in words */
std::string
describeDimensions (const std::string& name, const std::vector<std::uint8_t>& labels, Report& report,
                    Table& table)
{
  static const char* const KINDS[] = {"none", "curve", "surface", "solid"};
  Json::Value counts (Json::objectValue);
  std::string text;
  for (int dimension = 0; dimension <= 3; ++dimension) {
    const std::size_t count = countOf (labels, dimension);
    counts[KINDS[dimension]] = Json::UInt64 (count);
    if (dimension > 0)
      text += std::string (text.empty () ? "" : ", ") + grouped (count) + " " + KINDS[dimension];
  }
  report.result (name, counts);
  table.row (name, text);
  return text;
}

struct Request
{
  std::string input, output, only;
  SampleOptions options;
  bool published = false;
  std::vector<double> scales, origin;
};

// The class with what the user asked for. The cloud's own viewpoint is where the sensor stood, unless it is 0
// 0 0, which most files say whether it is true or not.
void
setUp (const Request& request, const InputCloud& input, pcl::DimensionDetection<pcl::PointXYZ>& detection)
{
  request.options.apply (detection);
  if (request.published)
    detection.setScales (Scales::OFF);
  if (!request.scales.empty ())
    detection.setScaleRange (request.scales[0], request.scales[1]);
  const Eigen::Vector3d shift (input.origin[0], input.origin[1], input.origin[2]);
  const Eigen::Vector3d viewpoint (input.viewpoint[0], input.viewpoint[1], input.viewpoint[2]);
  if (!request.origin.empty ())
    detection.setSensorOrigin (Eigen::Vector3d (request.origin[0], request.origin[1], request.origin[2]) -
                               shift);
  else if (request.scales.empty () && !(viewpoint + shift).isZero (0.0))
    detection.setSensorOrigin (viewpoint);
}

void
addScaleFields (const pcl::DimensionDetection<pcl::PointXYZ>& detection, pcl::PCLPointCloud2& cloud)
{
  setField (cloud, "scale", detection.getScale ());
  setField (cloud, "persistence", detection.getPersistence ());
  setField (cloud, "curve", detection.getCurveOfPoint ());
  const Eigen::Matrix3Xf tangents = detection.getTangents ();
  const char* const names[] = {"tangent_x", "tangent_y", "tangent_z"};
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<float> along (static_cast<std::size_t> (tangents.cols ()));
    Eigen::Map<Eigen::RowVectorXf> (along.data (), tangents.cols ()) = tangents.row (axis);
    setField (cloud, names[axis], along);
  }
}

// Within 20 degrees of the vertical, or of the horizontal.
bool
isWanted (const std::string& only, const CurveMeasures& curve)
{
  constexpr double COS_20 = 0.9396926207859084;
  constexpr double SIN_20 = 0.3420201433256687;
  return only == "vertical" ? curve.verticality > COS_20 : curve.verticality < SIN_20;
}

// Leaves the points of curves of one direction.
void
keepOnly (const std::string& only, const pcl::DimensionDetection<pcl::PointXYZ>& detection,
          pcl::PCLPointCloud2& cloud)
{
  const std::vector<CurveMeasures> curves = detection.getCurves ();
  const std::vector<std::int32_t> curve_of = detection.getCurveOfPoint ();
  std::vector<std::uint8_t> kept;
  for (std::size_t i = 0; i < curve_of.size (); ++i)
    if (curve_of[i] >= 0 && isWanted (only, curves[static_cast<std::size_t> (curve_of[i])])) {
      const auto begin = cloud.data.begin () + static_cast<std::ptrdiff_t> (i * cloud.point_step);
      kept.insert (kept.end (), begin, begin + cloud.point_step);
    }
  cloud.data = std::move (kept);
  cloud.width = static_cast<std::uint32_t> (cloud.data.size () / cloud.point_step);
  cloud.height = 1;
  cloud.row_step = static_cast<std::uint32_t> (cloud.data.size ());
}

void
describeCurves (const pcl::DimensionDetection<pcl::PointXYZ>& detection, Report& report, Table& table)
{
  Json::Value list (Json::arrayValue);
  std::size_t vertical = 0, horizontal = 0;
  for (const CurveMeasures& curve : detection.getCurves ()) {
    vertical += isWanted ("vertical", curve) ? 1 : 0;
    horizontal += isWanted ("horizontal", curve) ? 1 : 0;
    Json::Value entry;
    entry["points"] = Json::UInt64 (curve.points);
    entry["length"] = curve.length;
    entry["height"] = curve.height;
    entry["verticality"] = curve.verticality;
    entry["mean_radius"] = curve.mean_radius;
    list.append (entry);
  }
  const std::string text =
    grouped (list.size ()) + ", vertical " + grouped (vertical) + ", horizontal " + grouped (horizontal);
  report.result ("curves", list);
  table.row ("curves", text);
  report.say ({"curves: " + text});
  if (detection.getSensorOrigin ()) {
    Json::Value place (Json::arrayValue);
    for (const double coordinate : *detection.getSensorOrigin ())
      place.append (coordinate + 0.0); // no -0
    report.result ("sensor_origin", place);
    report.say ({"a single frame of a sensor: looked at in its coordinates"});
  }
}

void
run (const Request& request)
{
  const CommonOptions& common = request.options.common;
  requireType ("OUTPUT", request.output, {".pcd"});
  if (!request.only.empty () && request.only != "vertical" && request.only != "horizontal")
    throw UsageError ("-only", "'" + request.only + "' is neither vertical nor horizontal");
  if (request.published && !(request.scales.empty () && request.origin.empty () && request.only.empty ()))
    throw UsageError ("-published", "does not go together with -scale, -origin and -only");
  if (!request.scales.empty () && !request.origin.empty ())
    throw UsageError ("-scale", "does not go together with -origin");
  checkWritable (request.output);
  request.options.checkReport ();
  const Picture picture (common.picture);
  InputCloud input = readCloud (request.input);
  printNotes (input, common.quiet);

  pcl::DimensionDetection<pcl::PointXYZ> detection;
  detection.setInputCloud (pointsOf (input));
  setUp (request, input, detection);
  pcl::PointCloud<pcl::Label> labels;
  {
    Progress progress ("dimension", common.quiet);
    // As published, the library's part of the work ends at 0.7: the rest is that of CoconeShape.
    const float all = request.published ? 0.7f : 1.0f;
    detection.setProgressCallback (
      [&progress, all] (float fraction) { return progress.update (fraction / all); });
    detection.compute (labels);
  }
  requireOk (request.input, detection.getStatus ());

  std::vector<std::uint8_t> dimension (labels.size ());
  std::transform (labels.begin (), labels.end (), dimension.begin (),
                  [] (const pcl::Label& label) { return static_cast<std::uint8_t> (label.label); });
  const std::vector<std::uint8_t> manifold_dimension = detection.getManifoldDimension ();
  const std::vector<std::uint8_t> boundary = detection.getBoundary ();
  setField (input.cloud, "dimension", dimension);
  setField (input.cloud, "manifold_dimension", manifold_dimension);
  setField (input.cloud, "boundary", boundary);
  setField (input.cloud, "confidence", detection.getConfidence ());

  Report report ("pcl_dimension_detection");
  Table table;
  const PointCounts counts = countsOf (input, *detection.getSampleSet ());
  noteLeftOut (input, counts, common.quiet);
  describeInput (input, counts, report, table);
  request.options.describe (report);
  report.parameter ("published", request.published);
  if (const auto complex = detection.getDelaunayComplex ()) {
    report.result ("affine_dimension", complex->affine_dimension);
    report.result ("tetrahedra", complex->finite_cells);
  }
  describeDimensions ("dimension", dimension, report, table);
  report.say (
    {"points by dimension: " + describeDimensions ("manifold_dimension", manifold_dimension, report, table)});
  report.result ("boundary", Json::UInt64 (countOf (boundary, 1)));
  table.row ("boundary", countOf (boundary, 1));
  if (request.published) {
    describeContradiction (input, detection.getContradictedCount (), counts, request.options, report);
  } else {
    addScaleFields (detection, input.cloud);
    describeCurves (detection, report, table);
  }
  describeStages (detection.getStages (), report, table);

  const auto positions = positionsOf (input.cloud);
  picture.draw (request.input, {{"dimension, as published", layersByDimension (positions, dimension)},
                                {"manifold dimension", layersByDimension (positions, manifold_dimension)}});
  if (!request.only.empty ())
    keepOnly (request.only, detection, input.cloud);
  writePcd (request.output, input.cloud, input.viewpoint);
  report.finish (common, table);
}

} // namespace

int
main (int argc, char** argv)
{
  CommandLine command_line (
    "pcl_dimension_detection",
    "Tells for every point of a cloud the dimension of the shape that it lies on: 1 curve, 2 surface, 3 "
    "solid,\n"
    "and from which scale on. Nothing has to be set. Adds the fields manifold_dimension, scale, "
    "persistence,\n"
    "boundary (is it on the rim, skin or end of its manifold), confidence, dimension (as published: 1 also "
    "at the\n"
    "rim of a surface, 2 also at the skin of a solid), curve (a number, or -1) and tangent_x, tangent_y, "
    "tangent_z.");
  Request request;
  command_line.positional ("INPUT", std::string ("cloud: ") + cloud_file_types, request.input)
    .positional ("OUTPUT", "cloud with the fields of the input and the new ones: .pcd", request.output)
    .flag ("published", "the published method alone, once, on the points as they are or are thinned",
           request.published)
    .numbers ("scale", "FROM TO",
              "spacings to ask at; else from that of the points to an eighth of the extent", 2,
              request.scales)
    .numbers (
      "origin", "X Y Z",
      "where the sensor of a single frame stood; else the VIEWPOINT of the file, or 0 0 0 where rings of\n"
      "a spinning lidar are around it",
      3, request.origin)
    .option ("only", "DIRECTION", "write the points of vertical or of horizontal curves alone", request.only)
    .example ("pcl_dimension_detection scan.pcd dimensions.pcd -picture dimensions.png");
  request.options.declare (command_line);
  return runApp (argc, argv, command_line, [&] { run (request); });
}
