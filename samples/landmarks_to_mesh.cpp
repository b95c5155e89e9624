#include "app_error.h"
#include "app_files.h"
#include "app_main.h"
#include "complex_layers.h"
#include "graph_options.h"
#include "mesh_distance.h"
#include "picture.h"
#include "polygon_triangles.h"
#include "progress.h"
#include "sample_input.h"
#include "topology_json.h"

#include <pcl/manifold/complex_io.h>
#include <pcl/manifold/fixed_point_reconstruction.h>
#include <pcl/manifold/graph_reconstruction.h>
#include <pcl/manifold/mesh_pieces.h>

#include <iomanip>
#include <sstream>

// From a mesh over a few points, made of neighbourhoods alone, to one over all of them: GraphReconstruction,
// and then the restricted Delaunay operator until nothing changes.

using namespace pcl::manifold;
using namespace pcl::manifold::apps;

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Triangles = std::vector<pcl::SimplicialComplex::Triangle>;

pcl::PolygonMesh::Ptr
landmarkMesh (const InputCloud& input, const Cloud::Ptr& cloud, const GraphOptions& options)
{
  pcl::GraphReconstruction<pcl::PointXYZ> reconstruction;
  reconstruction.setInputCloud (cloud);
  options.apply (reconstruction);
  Progress progress ("landmarks", options.common.quiet);
  reconstruction.setProgressCallback (progress.callback ());
  const auto mesh = pcl::make_shared<pcl::PolygonMesh> ();
  reconstruction.reconstruct (*mesh);
  if (reconstruction.getStatus () == Status::DIMENSION_TOO_LOW)
    throw AppError (input.file, "has no mesh of landmarks; fewer -hops make it finer");
  requireOk (input.file, reconstruction.getStatus ());
  return mesh;
}

/** \brief The mesh of landmarks, what the operator makes of it, what it makes of that, and so on until
 * nothing changes. */
std::vector<Triangles>
iterate (const pcl::PolygonMesh& landmarks, const DelaunayComplex& complex)
{
  std::vector<Triangles> meshes = {trianglesOf (landmarks).triangles};
  FlatPieces pieces;
  meshPieces (landmarks, pieces);
  pieces.vertices = (pieces.vertices.colwise () - complex.samples->origin) * complex.samples->scale;
  FacetFlags before;
  FacetFlags after;
  restrictedDelaunay (complex, pieces, after);
  while (after != before) {
    meshes.push_back (facetShape (complex, after).triangles);
    before.mask.swap (after.mask);
    after = restrictedDelaunay (complex, before);
  }
  return meshes;
}

/** \brief A number with its share of the mean edge. */
std::string
distanceText (double distance, double edge)
{
  std::ostringstream text;
  text << std::setprecision (3) << distance << " (" << distance / edge << " edges)";
  return text.str ();
}

/** \brief Reports how each mesh differs from the last one. */
void
describeMeshes (const std::vector<Triangles>& meshes, const Eigen::Matrix3Xd& points, Report& report,
                Table& table)
{
  const TriangleMesh last{points, meshes.back ()};
  const double edge = meanEdge (last);
  const double step = 0.5 * edge;
  const Eigen::Matrix3Xd places = placesOn (last, step);
  Json::Value list (Json::arrayValue);
  for (std::size_t i = 0; i < meshes.size (); ++i) {
    const TriangleMesh mesh{points, meshes[i]};
    pcl::SimplicialComplex complex;
    complex.triangles = meshes[i];
    const SurfaceTopology topology = analyze (complex).surface;
    double distance = 0.0;
    if (i + 1 < meshes.size () && !meshes[i].empty ())
      distance = std::max (largestDistance (placesOn (mesh, step), last), largestDistance (places, mesh));
    Json::Value json (Json::objectValue);
    json["triangles"] = Json::UInt64 (topology.faces);
    json["vertices"] = Json::UInt64 (topology.vertices);
    json["non_manifold_edges"] = Json::UInt64 (topology.non_manifold_edges);
    json["boundary_loops"] = Json::UInt64 (topology.boundary_loops);
    json["hausdorff_distance"] = distance;
    list.append (json);
    table.row (i == 0 ? "landmarks" : "iteration " + std::to_string (i),
               grouped (topology.faces) + " triangles, " + grouped (topology.non_manifold_edges) +
                 " edges of more than two, " + grouped (topology.boundary_loops) +
                 " loops; Hausdorff distance to the last " + distanceText (distance, edge));
  }
  report.result ("meshes", list);
  report.result ("mean_edge", edge);
  report.result ("iterations", Json::UInt64 (meshes.size () - 1));
}

} // namespace

int
main (int argc, char** argv)
{
  CommandLine command_line (
    "landmarks_to_mesh",
    "Meshes a few points of a cloud, from the neighbourhoods of all points alone, and makes of that a mesh "
    "of\n"
    "all points, by iterating the restricted Delaunay triangulation; tells how each iteration moves it.");
  std::string input_file;
  std::string output_file;
  GraphOptions options;
  // The operator needs a start that is nearer to the surface than that of the default.
  options.parameters.hops = 3;
  const CommonOptions& common = options.common;
  command_line.positional ("INPUT", std::string ("cloud: ") + cloud_file_types, input_file)
    .positional ("OUTPUT", "mesh: .ply .obj .vtk .vtu", output_file);
  options.declare (command_line);
  command_line.common (options.common).example ("landmarks_to_mesh scan.pcd mesh.ply -picture mesh.png");

  return runApp (argc, argv, command_line, [&] {
    options.complete ();
    std::string error;
    if (!canSaveComplex (output_file, error))
      throw AppError (output_file, error);
    if (!common.report.empty ())
      checkWritable (common.report);
    const Picture picture (common.picture);
    const InputCloud input = readCloud (input_file);
    printNotes (input, common.quiet);
    const Cloud::Ptr cloud = pointsOf (input);
    const pcl::PolygonMesh::Ptr landmarks = landmarkMesh (input, cloud, options);

    pcl::FixedPointReconstruction<pcl::PointXYZ> reconstruction;
    reconstruction.setInputCloud (cloud);
    reconstruction.setInitialMesh (landmarks);
    reconstruction.setNumberOfThreads (options.parameters.threads);
    pcl::SimplicialComplex surface;
    {
      Progress progress ("surface", common.quiet);
      reconstruction.setProgressCallback (progress.callback ());
      reconstruction.reconstruct (surface);
    }
    requireOk (input_file, reconstruction.getStatus ());
    const DelaunayComplex& complex = *reconstruction.getDelaunayComplex ();

    Report report ("landmarks_to_mesh");
    Table table;
    const PointCounts counts = countsOf (input, *complex.samples);
    noteLeftOut (input, counts, common.quiet);
    describeInput (input, counts, report, table);
    options.describe (report);
    describeMeshes (iterate (*landmarks, complex), cloud->getMatrixXfMap (3, 4, 0).cast<double> (), report,
                    table);
    describeTopology (analyze (surface), static_cast<std::size_t> (complex.samples->size ()), report, table);
    describeStages (reconstruction.getStages (), report, table);

    if (!saveComplex (output_file, input.cloud, surface, error))
      throw AppError (output_file, error);
    const auto positions = positionsOf (input.cloud);
    picture.draw (input_file, {{"landmarks", layersOf (positions, trianglesOf (*landmarks))},
                               {"fixed point", layersOf (positions, surface)}});
    report.finish (common, table);
  });
}
