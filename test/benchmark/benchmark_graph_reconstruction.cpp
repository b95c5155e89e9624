#include "graph_models.h"
#include "graph_paper_tables.h"
#include "peak_memory.h"

#include <app_error.h>
#include <app_main.h>
#include <graph_options.h>

#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/manifold/graph_reconstruction.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <map>
#include <thread>

// The tables of the paper, ours beside the paper's figures; -h says how.

namespace {

using namespace benchmark;
using pcl::manifold::apps::AppError;
using pcl::manifold::apps::GraphOptions;
using pcl::manifold::apps::UsageError;
using Reconstruction = pcl::GraphReconstruction<pcl::PointXYZ>;

/** \brief What the command line asks for. */
struct Request
{
  std::string table;
  std::string hops;
  std::string thresholds;
  int runs = 3;
  bool peer = false;
  GraphOptions options;

  unsigned int threads () const
  {
    const unsigned int asked = options.parameters.threads;
    return asked == 0 ? std::max (1U, std::thread::hardware_concurrency ()) : asked;
  }
};

double
median (std::vector<double> values)
{
  std::sort (values.begin (), values.end ());
  return values.empty () ? 0.0 : values[values.size () / 2];
}

/** \brief Runs once. \throws AppError if that fails */
void
run (const std::string& name, Reconstruction& reconstruction)
{
  std::vector<pcl::Vertices> polygons;
  reconstruction.reconstruct (polygons);
  const pcl::manifold::Status status = reconstruction.getStatus ();
  if (status != pcl::manifold::Status::OK && status != pcl::manifold::Status::DIMENSION_TOO_LOW)
    throw AppError (name, pcl::manifold::toString (status));
}

// ---- Table I ----

/** \brief The seconds that one thread takes to find the neighbours of all points by the search that PCL's
 * users would write, point after point in their order. */
double
secondsOfPcl (const pcl::PointCloud<pcl::PointXYZ>::Ptr& cloud, int k)
{
  const auto start = std::chrono::steady_clock::now ();
  pcl::KdTreeFLANN<pcl::PointXYZ> tree;
  tree.setInputCloud (cloud);
  pcl::Indices found;
  std::vector<float> distances;
  for (std::size_t i = 0; i < cloud->size (); ++i)
    tree.nearestKSearch (static_cast<pcl::index_t> (i), k + 1, found, distances);
  return std::chrono::duration<double> (std::chrono::steady_clock::now () - start).count ();
}

void
printTimesHeader (unsigned int threads)
{
  std::printf (
    "Table I: seconds with %u threads (medians). Sort: points sorted along a curve; the paper's "
    "octree.\nrest/Ngb: all after the neighbourhood graph over that graph. Mpts: million points a "
    "second and core of Sort and Ngb.\n"
    "B/pt: peak of resident memory beyond the cloud.\nWith -peer, of pcl::KdTreeFLANN, asked "
    "for one point after the other by one thread:\nPCL: seconds in the order of the cloud; x PCL: these "
    "over those of Sort and Ngb, times the threads.\nPCLs: seconds on the points as Sort leaves them; x "
    "PCLs: "
    "these over those of Ngb, times the threads.\n\n",
    threads);
  std::printf ("%-24s %9s %7s %7s %7s %7s %7s %7s %7s %9s %6s %6s %7s %6s %7s %6s\n", "model", "points",
               "Sort", "Ngb", "MIS", "Vor", "Adj", "Cyc", "total", "rest/Ngb", "Mpts", "B/pt", "PCL", "x PCL",
               "PCLs", "x PCLs");
}

void
printPaperTimes (const paper::Model& model)
{
  const double rest = model.landmarks + model.voronoi + model.adjacency + model.cycles;
  const double search = model.octree + model.neighbors;
  std::printf ("%-24s %9zu %7.1f %7.1f %7.1f %7.1f %7.1f %7.1f %7.1f %9.2f %6.3f\n",
               (std::string ("  paper: ") + model.name).c_str (), model.points, model.octree, model.neighbors,
               model.landmarks, model.voronoi, model.adjacency, model.cycles, search + rest,
               rest / model.neighbors, static_cast<double> (model.points) / search / 1e6);
}

void
printTimes (const GraphModel& model, const Request& request)
{
  const pcl::PointCloud<pcl::PointXYZ>::Ptr cloud = model.points ();
  const auto n = static_cast<double> (cloud->size ());
  std::map<std::string, std::vector<double>> seconds;
  double bytes = 0.0;
  pcl::Indices sorted;
  for (int i = 0; i < request.runs; ++i) {
    Reconstruction reconstruction;
    reconstruction.setInputCloud (cloud);
    request.options.apply (reconstruction);
    const std::size_t before = resetPeakMemory ();
    run (model.name, reconstruction);
    if (before > 0)
      bytes = std::max (bytes, static_cast<double> (peakMemory () - before) / n);
    std::map<std::string, double> of_run; // some stages are there twice
    for (const pcl::manifold::Stage& stage : reconstruction.getStages ())
      of_run[stage.name] += stage.seconds;
    for (const auto& [name, taken] : of_run)
      seconds[name].push_back (taken);
    sorted = reconstruction.getVertices ();
  }
  const auto of = [&seconds] (const char* stage) { return median (seconds[stage]); };
  const double search = of ("points") + of ("neighbourhood graph");
  const double cycles = of ("faces") + of ("triangulation");
  const double rest =
    of ("stable set") + of ("refinement") + of ("graph Voronoi diagram") + of ("adjacency") + cycles;
  std::printf ("%-24.24s %9.0f %7.3f %7.3f %7.3f %7.3f %7.3f %7.3f %7.3f %9.2f %6.3f %6.0f",
               model.name.c_str (), n, of ("points"), of ("neighbourhood graph"),
               of ("stable set") + of ("refinement"), of ("graph Voronoi diagram"), of ("adjacency"), cycles,
               search + rest, rest / of ("neighbourhood graph"), n / search / request.threads () / 1e6,
               bytes);
  if (request.peer) {
    const int k = request.options.parameters.k_search;
    const double in_order = secondsOfPcl (cloud, k);
    const double equally_sorted =
      secondsOfPcl (pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>> (*cloud, sorted), k);
    std::printf (" %7.3f %6.1f %7.3f %6.1f", in_order, in_order / search / request.threads (), equally_sorted,
                 equally_sorted / of ("neighbourhood graph") / request.threads ());
  }
  std::printf ("\n");
  if (const auto published = paper::modelOf (cloud->size ()))
    printPaperTimes (*published);
  std::fflush (stdout);
}

// ---- Table II ----

void
printSubsample (const GraphModel& model, const Request& request)
{
  const pcl::PointCloud<pcl::PointXYZ>::Ptr cloud = model.points ();
  Reconstruction reconstruction;
  reconstruction.setInputCloud (cloud);
  request.options.apply (reconstruction);
  run (model.name, reconstruction);
  const std::size_t landmarks = reconstruction.getLandmarks ().size ();
  std::printf ("%-24.24s %9zu %10zu %12.1f", model.name.c_str (), cloud->size (), landmarks,
               static_cast<double> (cloud->size ()) / static_cast<double> (landmarks));
  if (const auto published = paper::modelOf (cloud->size ()))
    std::printf (" %10zu %12.1f", published->subsample,
                 static_cast<double> (published->points) / static_cast<double> (published->subsample));
  std::printf ("\n");
}

// ---- Table III ----

void
printParameterRow (const Reconstruction& reconstruction, std::size_t points)
{
  const pcl::TopologyReport& report = reconstruction.getReport ();
  const pcl::manifold::SurfaceTopology& surface = report.surface;
  const std::size_t edges = report.curve.edges + surface.edges;
  const auto percent = [] (std::size_t part, std::size_t whole) {
    return whole == 0 ? 0.0 : 100.0 * static_cast<double> (part) / static_cast<double> (whole);
  };
  std::printf ("%5d %5d %10zu %8zu %8zu %9.1f%% %7d %10.2f%% %6zu %6zu", reconstruction.getHops (),
               reconstruction.getAdjacencyThreshold (), reconstruction.getLandmarks ().size (), edges,
               surface.faces, percent (surface.triangles, surface.faces),
               surface.components.empty () ? -1 : surface.components.front ().genus,
               percent (surface.inner_edges, edges), surface.components.size (), surface.boundary_loops);
  if (points == paper::BUNNY_POINTS)
    for (const paper::Parameters& row : paper::BUNNY)
      if (row.hops == reconstruction.getHops () && row.threshold == reconstruction.getAdjacencyThreshold ()) {
        std::printf (" | %6zu", row.faces);
        if (row.triangles > 0.0)
          std::printf (" %6.1f%%", row.triangles);
        else
          std::printf (" %7s", "-");
        std::printf (" %6g", row.genus);
        break;
      }
  std::printf ("\n");
  std::fflush (stdout);
}

void
printParameters (const GraphModel& model, const Request& request)
{
  const pcl::PointCloud<pcl::PointXYZ>::Ptr cloud = model.points ();
  std::printf ("\n%s, %zu points\n%5s %5s %10s %8s %8s %10s %7s %11s %6s %6s%s\n", model.name.c_str (),
               cloud->size (), "k", "a", "landmarks", "edges", "faces", "triangles", "genus", "in 2 faces",
               "comp.", "loops",
               cloud->size () == paper::BUNNY_POINTS ? " | paper: faces, triangles, genus" : "");
  Reconstruction reconstruction;
  reconstruction.setInputCloud (cloud);
  request.options.apply (reconstruction);
  const auto print = [&] (int hops, int threshold) {
    reconstruction.setHops (hops);
    reconstruction.setAdjacencyThreshold (threshold);
    run (model.name, reconstruction);
    printParameterRow (reconstruction, cloud->size ());
  };
  const pcl::manifold::GraphParameters& fixed = request.options.parameters;
  for (const int hops : numbersOf (request.hops))
    print (hops, fixed.adjacency_threshold);
  for (const int threshold : numbersOf (request.thresholds))
    if (threshold != fixed.adjacency_threshold)
      print (fixed.hops, threshold);
}

void
printTable (const Request& request, const std::vector<GraphModel>& models)
{
  void (*print) (const GraphModel&, const Request&) = nullptr;
  if (request.table == "times") {
    printTimesHeader (request.threads ());
    print = printTimes;
  } else if (request.table == "subsamples") {
    std::printf (
      "Table II: landmarks (k = %d, %d hops). Ours are fewer: they are taken in random order, the paper's "
      "in that of the file,\nwhich packs them closer. And its tables II and III do not go together: a closed "
      "mesh of the bunny's 868\nlandmarks with 95 %% triangles has some 1700 faces, not 976.\n\n%-24s %9s "
      "%10s %12s %10s %12s\n",
      request.options.parameters.k_search, request.options.parameters.hops, "model", "points", "landmarks",
      "points each", "paper's", "points each");
    print = printSubsample;
  } else if (request.table == "parameters") {
    std::printf (
      "Table III: dependence on the hops k and the threshold a. The genus is that of equation 2, to which "
      "every boundary\nloop adds a half: the bunny has holes in its base.\n");
    print = printParameters;
  } else
    throw UsageError ("TABLE", "'" + request.table + "' is none of times, subsamples, parameters");
  for (const GraphModel& model : models)
    print (model, request);
}

} // namespace

int
main (int argc, char** argv)
{
  using pcl::manifold::apps::CommandLine;
  CommandLine command_line ("benchmark_graph_reconstruction",
                            "Prints a table of the paper for clouds, beside the paper's figures.");
  Request request;
  std::string files;
  std::string shapes;
  std::string sizes = "1e5";
  request.hops = "2-5,7,14,15";
  request.thresholds = "2,3,6,7,11,15,20";
  bool even = false;
  command_line.positional ("TABLE", "times (table I), subsamples (II) or parameters (III)", request.table);
  request.options.declare (command_line);
  command_line.option ("files", "F,F", "clouds", files)
    .option ("shapes", "S,S", "generated clouds, as generate_cloud -list names them", shapes)
    .option ("sizes", "N,N", "numbers of their points", sizes)
    .flag ("even", "blue noise instead of independent points", even)
    .option ("table-hops", "K,K-K", "hops of table III", request.hops)
    .option ("table-as", "A,A-A", "thresholds of table III", request.thresholds)
    .flag ("peer", "let PCL's kd-tree find the neighbours as well, of the points in their order and sorted",
           request.peer)
    .option ("runs", "n", "runs of which table I gives the medians", request.runs, {1, 1000})
    .option ("threads", "n", "0 = all", request.options.common.threads, {0, 1024})
    .example ("benchmark_graph_reconstruction times -files bunny_35947.pcd,dragon_435545.pcd")
    .example ("benchmark_graph_reconstruction times -shapes torus -sizes 1e5,1e6,1e7 -threads 1")
    .example ("benchmark_graph_reconstruction parameters -files bunny_35947.pcd -faces cycles")
    .example ("benchmark_graph_reconstruction parameters -shapes sphere,torus -table-hops 3-12 -table-as 7");
  return pcl::manifold::apps::runApp (argc, argv, command_line, [&] {
    request.options.complete ();
    std::vector<GraphModel> models = modelsOfFiles (files);
    for (GraphModel& model : generatedModels (shapes, sizes, even, request.options.parameters.seed))
      models.push_back (std::move (model));
    if (models.empty ())
      throw UsageError ("-files", "there is no cloud: name some, or some -shapes");
    printTable (request, models);
  });
}
