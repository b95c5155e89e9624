#include "app_error.h"
#include "app_files.h"
#include "app_main.h"
#include "complex_layers.h"
#include "picture.h"
#include "progress.h"
#include "sample_input.h"
#include "topology_json.h"

#include <pcl/manifold/cocone_shape.h>
#include <pcl/manifold/complex_io.h>

using namespace pcl::manifold;
using namespace pcl::manifold::apps;

namespace {

// The dimension of the manifold that every point belongs to.
std::vector<std::uint8_t>
dimensionsOfPoints (const SampleDimensions& dimensions)
{
  const std::vector<std::int32_t>& sample_of = dimensions.complex->samples->sample_of;
  std::vector<std::uint8_t> result (sample_of.size (), 0);
  for (std::size_t i = 0; i < sample_of.size (); ++i)
    if (sample_of[i] >= 0)
      result[i] = dimensions.manifold_dimension[sample_of[i]];
  return result;
}

} // namespace

int
main (int argc, char** argv)
{
  CommandLine command_line (
    "pcl_cocone_shape",
    "Reconstructs the curves, surfaces and solids of a cloud as edges, triangles and tetrahedra\n"
    "over its points.");
  std::string input_file;
  std::string output_file;
  bool watertight = false;
  SampleOptions options;
  const CommonOptions& common = options.common;
  command_line.positional ("INPUT", std::string ("cloud: ") + cloud_file_types, input_file)
    .positional ("OUTPUT", "mesh: .ply .obj .vtk .vtu (tetrahedra in the last two only, else their boundary)",
                 output_file)
    .flag ("watertight", "close every surface", watertight)
    .example ("pcl_cocone_shape scan.pcd shape.ply -report shape.json -picture shape.png");

  options.declare (command_line);

  return runApp (argc, argv, command_line, [&] {
    std::string error;
    if (!canSaveComplex (output_file, error))
      throw AppError (output_file, error);
    options.checkReport ();
    const Picture picture (common.picture);
    const InputCloud input = readCloud (input_file);
    printNotes (input, common.quiet);

    pcl::CoconeShape<pcl::PointXYZ> reconstruction;
    reconstruction.setInputCloud (pointsOf (input));
    options.apply (reconstruction);
    reconstruction.setWatertight (watertight);
    pcl::SimplicialComplex shape;
    {
      Progress progress ("shape", common.quiet);
      reconstruction.setProgressCallback (progress.callback ());
      reconstruction.reconstruct (shape);
    }
    requireOk (input_file, reconstruction.getStatus ());

    Report report ("pcl_cocone_shape");
    Table table;
    const PointCounts counts = countsOf (input, *reconstruction.getDelaunayComplex ()->samples);
    noteLeftOut (input, counts, common.quiet);
    describeInput (input, counts, report, table);
    describeContradiction (input, reconstruction.getContradictedCount (), counts, options, report);
    options.describe (report);
    report.parameter ("watertight", watertight);
    describeTopology (analyze (shape), counts.samples, report, table);
    describeStages (reconstruction.getStages (), report, table);

    if (!saveComplex (output_file, input.cloud, shape, error))
      throw AppError (output_file, error);
    const auto positions = positionsOf (input.cloud);
    picture.draw (
      input_file,
      {{"points", layersByDimension (positions, dimensionsOfPoints (*reconstruction.getSampleDimensions ()))},
       {"shape", layersOf (positions, shape)}});
    report.finish (common, table);
  });
}
