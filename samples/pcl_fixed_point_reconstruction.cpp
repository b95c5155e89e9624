#include "app_error.h"
#include "app_main.h"
#include "complex_layers.h"
#include "mesh_reader.h"
#include "picture.h"
#include "progress.h"
#include "sample_input.h"
#include "topology_json.h"

#include <pcl/manifold/complex_io.h>
#include <pcl/manifold/fixed_point_reconstruction.h>

#include <optional>

using namespace pcl::manifold;
using namespace pcl::manifold::apps;

namespace {

using Reconstruction = pcl::FixedPointReconstruction<pcl::PointXYZ>;

/** \brief What the user asked for. */
struct Request
{
  std::string input, output;
  std::string initial; ///< mesh to start from; empty: none
  double ratio = Reconstruction ().getCriticalRatio ();
  int votes = Reconstruction ().getVotes ();
  bool watertight = false;
  ThinningOptions options;
};

void
declare (CommandLine& command_line, Request& request)
{
  command_line.positional ("INPUT", std::string ("cloud: ") + cloud_file_types, request.input)
    .positional ("OUTPUT", "mesh: .ply .obj .vtk .vtu", request.output)
    .option ("ratio", "r",
             "circumcentres further from a corner than this times the distance of its pole are near the\n"
             "medial axis; 0.313 is the published constant, for 0.143-samples of smooth closed surfaces",
             request.ratio, {1e-9, 1e9})
    .option ("votes", "n", "so many of the three corners have to say so; 1 with the published constant",
             request.votes, {1, 3})
    .option ("initial", "MESH",
             "start from a mesh near the surface and follow it to a fixed point:\n" +
               std::string (mesh_file_types) + "; -ratio, -votes and -watertight play no part then",
             request.initial)
    .flag ("watertight", "close every surface", request.watertight);
  request.options.declare (command_line);
  command_line
    .example ("pcl_fixed_point_reconstruction scan.pcd mesh.ply -report mesh.json -picture mesh.png")
    .example ("pcl_fixed_point_reconstruction dense.xyz mesh.ply -ratio 0.313 -votes 1")
    .example ("pcl_fixed_point_reconstruction scan.pcd fine.ply -initial coarse.ply");
}

void
describeParameters (const Request& request, Report& report)
{
  if (request.initial.empty ()) {
    report.parameter ("ratio", request.ratio);
    report.parameter ("votes", request.votes);
    report.parameter ("watertight", request.watertight);
  } else
    report.parameter ("initial", request.initial);
  request.options.describe (report);
}

void
describeTriangles (const Request& request, const Reconstruction& reconstruction, Report& report, Table& table)
{
  if (!request.initial.empty ()) {
    report.result ("iterations", reconstruction.getIterations ());
    table.row ("iterations", std::to_string (reconstruction.getIterations ()));
    return;
  }
  const FixedPointCounts counts = reconstruction.getCounts ();
  report.result ("anchored", Json::UInt64 (counts.anchored));
  report.result ("medial", Json::UInt64 (counts.medial));
  report.result ("chained", Json::UInt64 (counts.chained));
  table.row ("anchored triangles", grouped (counts.anchored) + ", " + grouped (counts.medial) + " medial");
  table.row ("chained triangles", counts.chained);
}

void
drawPicture (const Picture& picture, const InputCloud& input, const std::optional<InputMesh>& initial,
             const pcl::SimplicialComplex& surface)
{
  const auto positions = positionsOf (input.cloud);
  const std::vector<std::uint8_t> dimensions (positions->size (), 2);
  const Panel before = initial
                         ? Panel{"initial mesh", layersOf (positionsOf (initial->cloud), initial->complex)}
                         : Panel{"points", layersByDimension (positions, dimensions)};
  picture.draw (input.file, {before, {"surface", layersOf (positions, surface)}});
}

} // namespace

int
main (int argc, char** argv)
{
  CommandLine command_line (
    "pcl_fixed_point_reconstruction",
    "Reconstructs a surface over the points of a cloud: out of the triangles that the restricted Delaunay\n"
    "triangulation maps to themselves.");
  Request request;
  declare (command_line, request);

  return runApp (argc, argv, command_line, [&] {
    const CommonOptions& common = request.options.common;
    std::string error;
    if (!canSaveComplex (request.output, error))
      throw AppError (request.output, error);
    request.options.checkReport ();
    const Picture picture (common.picture);
    const InputCloud input = readCloud (request.input);
    printNotes (input, common.quiet);

    Reconstruction reconstruction;
    reconstruction.setInputCloud (pointsOf (input));
    request.options.apply (reconstruction);
    reconstruction.setCriticalRatio (request.ratio);
    reconstruction.setVotes (request.votes);
    reconstruction.setWatertight (request.watertight);
    std::optional<InputMesh> initial;
    if (!request.initial.empty ()) {
      initial = readMesh (request.initial, input);
      const auto mesh = pcl::make_shared<pcl::PolygonMesh> ();
      toPolygonMesh (initial->complex, initial->cloud, *mesh);
      reconstruction.setInitialMesh (mesh);
    }
    pcl::SimplicialComplex surface;
    {
      Progress progress ("surface", common.quiet);
      reconstruction.setProgressCallback (progress.callback ());
      reconstruction.reconstruct (surface);
    }
    if (reconstruction.getStatus () == Status::DIMENSION_TOO_LOW)
      throw AppError (request.input, "no surface was found: its points lie along curves, or are too few");
    requireOk (request.input, reconstruction.getStatus ());
    if (initial && surface.empty ())
      throw AppError (request.initial,
                      "leads to no triangle over " + request.input + ": is it in the same coordinates?");

    Report report ("pcl_fixed_point_reconstruction");
    Table table;
    const PointCounts counts = countsOf (input, *reconstruction.getDelaunayComplex ()->samples);
    noteLeftOut (input, counts, common.quiet);
    describeInput (input, counts, report, table);
    describeParameters (request, report);
    describeTriangles (request, reconstruction, report, table);
    describeTopology (analyze (surface), counts.samples, report, table);
    describeStages (reconstruction.getStages (), report, table);

    if (!saveComplex (request.output, input.cloud, surface, error))
      throw AppError (request.output, error);
    drawPicture (picture, input, initial, surface);
    report.finish (common, table);
  });
}
