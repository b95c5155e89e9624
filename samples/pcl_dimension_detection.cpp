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

} // namespace

int
main (int argc, char** argv)
{
  CommandLine command_line (
    "pcl_dimension_detection",
    "Tells for every point of a cloud the dimension of the shape that it lies on: 1 curve, 2 surface, 3 "
    "solid.\n"
    "Adds the fields dimension (as published: 1 also at the rim of a surface, 2 also at the skin of a "
    "solid),\n"
    "manifold_dimension, boundary (is it on the rim, skin or end of its manifold) and confidence.");
  std::string input_file;
  std::string output_file;
  SampleOptions options;
  const CommonOptions& common = options.common;
  command_line.positional ("INPUT", std::string ("cloud: ") + cloud_file_types, input_file)
    .positional ("OUTPUT", "cloud with the fields of the input and the new ones: .pcd", output_file)
    .example ("pcl_dimension_detection scan.pcd dimensions.pcd -thin 6 -picture dimensions.png");

  options.declare (command_line);

  return runApp (argc, argv, command_line, [&] {
    requireType ("OUTPUT", output_file, {".pcd"});
    checkWritable (output_file);
    options.checkReport ();
    const Picture picture (common.picture);
    InputCloud input = readCloud (input_file);
    printNotes (input, common.quiet);

    pcl::DimensionDetection<pcl::PointXYZ> detection;
    detection.setInputCloud (pointsOf (input));
    options.apply (detection);
    pcl::PointCloud<pcl::Label> labels;
    {
      Progress progress ("dimension", common.quiet);
      // The library's part of the work ends at 0.7: the rest is that of CoconeShape.
      detection.setProgressCallback (
        [&progress] (float fraction) { return progress.update (fraction / 0.7f); });
      detection.compute (labels);
    }
    requireOk (input_file, detection.getStatus ());

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
    const PointCounts counts = countsOf (input, *detection.getDelaunayComplex ()->samples);
    noteLeftOut (input, counts, common.quiet);
    describeInput (input, counts, report, table);
    describeContradiction (input, detection.getContradictedCount (), counts, options, report);
    options.describe (report);
    report.result ("affine_dimension", detection.getDelaunayComplex ()->affine_dimension);
    report.result ("tetrahedra", detection.getDelaunayComplex ()->finite_cells);
    describeDimensions ("dimension", dimension, report, table);
    report.say ({"points by dimension: " +
                 describeDimensions ("manifold_dimension", manifold_dimension, report, table)});
    report.result ("boundary", Json::UInt64 (countOf (boundary, 1)));
    table.row ("boundary", countOf (boundary, 1));
    describeStages (detection.getStages (), report, table);

    const auto positions = positionsOf (input.cloud);
    picture.draw (input_file, {{"dimension, as published", layersByDimension (positions, dimension)},
                               {"manifold dimension", layersByDimension (positions, manifold_dimension)}});
    writePcd (output_file, input.cloud, input.viewpoint);
    report.finish (common, table);
  });
}
