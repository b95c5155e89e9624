#include "app_error.h"
#include "app_files.h"
#include "app_main.h"
#include "complex_layers.h"
#include "graph_layers.h"
#include "graph_options.h"
#include "landmark_report.h"
#include "picture.h"
#include "polygon_triangles.h"
#include "progress.h"
#include "sample_input.h"
#include "topology_json.h"

#include <pcl/conversions.h>
#include <pcl/manifold/complex_io.h>
#include <pcl/manifold/graph_reconstruction.h>

#include <algorithm>

using namespace pcl::manifold;
using namespace pcl::manifold::apps;

namespace {

using Reconstruction = pcl::GraphReconstruction<pcl::PointXYZ>;

PointCounts
countsOf (const InputCloud& input, const Reconstruction& reconstruction)
{
  const std::vector<pcl::index_t> tiles = reconstruction.getTiles ();
  PointCounts counts;
  const auto left_out = static_cast<std::size_t> (std::count (tiles.begin (), tiles.end (), -1));
  counts.points = input.size ();
  counts.no_measurement = reconstruction.getNoMeasurementCount () + input.no_measurement;
  counts.dropped = left_out - counts.no_measurement;
  counts.samples = reconstruction.getVertices ().size ();
  counts.duplicates = input.size () - left_out - counts.samples;
  return counts;
}

void
drawPicture (const Picture& picture, const InputCloud& input, const Reconstruction& reconstruction)
{
  const std::vector<pcl::index_t> tiles = reconstruction.getTiles ();
  const pcl::Indices landmarks = reconstruction.getLandmarks ();
  constexpr int WIDTH = 1600;
  constexpr int HEIGHT = 1200;
  picture.draw (input.file,
                graphPanels ({positionsOf (input.cloud), tiles, landmarks, reconstruction.getAdjacency (),
                              reconstruction.getLandmarkMesh ()}),
                WIDTH, HEIGHT);
}

} // namespace

int
main (int argc, char** argv)
{
  CommandLine command_line (
    "pcl_graph_reconstruction",
    "Reconstructs a surface over a subset of the points of a cloud, the landmarks, from the neighbourhoods\n"
    "of the points alone: fast, and coarse.");
  std::string input_file;
  std::string output_file;
  GraphOptions options;
  const CommonOptions& common = options.common;
  command_line
    .positional ("INPUT",
                 std::string ("cloud: ") + cloud_file_types +
                   "; a .ply without header is read as text, a point a line",
                 input_file)
    .positional ("OUTPUT", "mesh over all points of the cloud: .ply .obj .vtk .vtu", output_file);
  options.declare (command_line);
  command_line.common (options.common)
    .example ("pcl_graph_reconstruction scan.pcd mesh.ply -report mesh.json -picture mesh.png")
    .example ("pcl_graph_reconstruction scan.xyz coarse.obj -hops 10 -polygons");

  return runApp (argc, argv, command_line, [&] {
    options.complete ();
    std::string error;
    if (!canSaveComplex (output_file, error))
      throw AppError (output_file, error);
    if (!common.report.empty ())
      checkWritable (common.report);
    const Picture picture (common.picture);
    const InputCloud input = readCloud (input_file, Reading::LAX);
    printNotes (input, common.quiet);

    Reconstruction reconstruction;
    reconstruction.setInputCloud (pointsOf (input));
    options.apply (reconstruction);
    pcl::PolygonMesh mesh;
    {
      Progress progress ("surface", common.quiet);
      reconstruction.setProgressCallback (progress.callback ());
      reconstruction.reconstruct (mesh.polygons);
    }
    if (reconstruction.getStatus () == Status::DIMENSION_TOO_LOW)
      throw AppError (input_file,
                      "no face was found: its points lie on no surface, or tiles are too few or touch "
                      "too little, see -hops, -a and -k");
    requireOk (input_file, reconstruction.getStatus ());

    Report report ("pcl_graph_reconstruction");
    Table table;
    const PointCounts counts = countsOf (input, reconstruction);
    noteLeftOut (input, counts, common.quiet);
    describeInput (input, counts, report, table);
    options.describe (report);
    describeLandmarks (reconstruction.getLandmarks ().size (), reconstruction.getReport (), report, table);
    report.result ("polygons", Json::UInt64 (mesh.polygons.size ()));
    table.row ("polygons written", mesh.polygons.size ());
    describeTopology (analyze (facesOf (mesh)), 0, report, table);
    describeStages (reconstruction.getStages (), report, table);

    mesh.cloud = input.cloud;
    if (!savePolygonMesh (output_file, mesh, error))
      throw AppError (output_file, error);
    drawPicture (picture, input, reconstruction);
    report.finish (common, table);
  });
}
