#include "advancing_front.h"
#include "graph_models.h"
#include "surface_measures.h"

#include <app_error.h>
#include <app_main.h>
#include <files/number_text.h>
#include <generate/catalogue.h>

#include <pcl/manifold/cocone_shape.h>
#include <pcl/manifold/fixed_point_reconstruction.h>
#include <pcl/manifold/graph_reconstruction.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <optional>
#include <string_view>

// FixedPointReconstruction beside CoconeShape and CGAL's advancing front; -h says how.

namespace {

using namespace benchmark;
using pcl::manifold::apps::UsageError;
using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Complex = std::shared_ptr<const pcl::manifold::DelaunayComplex>;
using FixedPoints = pcl::FixedPointReconstruction<pcl::PointXYZ>;
using Shapes = pcl::CoconeShape<pcl::PointXYZ>;

/** \brief A cloud to reconstruct, and the surface that was sampled where that is known. */
struct Model
{
  GraphModel cloud;
  std::optional<generate::Shape> shape;
};

/** \brief Values of setCriticalRatio () and setVotes (). */
struct Variant
{
  double ratio = 0.8;
  int votes = 3;
};

struct Request
{
  std::string table, hops = "2-5", variants = "0.313:1,0.8:3";
  int runs = 3;
  int threads = 0;
};

double
parseDouble (const std::string& text)
{
  double number = 0.0;
  if (!pcl::manifold::apps::parseNumber (std::string_view (text), number))
    throw UsageError (text, "is no number");
  return number;
}

std::vector<Variant>
variantsOf (const std::string& list)
{
  std::vector<Variant> variants;
  for (const std::string& part : splitAtCommas (list)) {
    const std::size_t colon = part.find (':');
    if (colon == std::string::npos)
      throw UsageError (part, "is no variant, which is a ratio and a number of votes, such as 0.8:3");
    variants.push_back (
      {parseDouble (part.substr (0, colon)), static_cast<int> (parseDouble (part.substr (colon + 1)))});
  }
  return variants;
}

/** \brief Those points that are finite: CGAL takes no others. */
Eigen::Matrix3Xd
pointsOf (const Cloud& cloud)
{
  return cloud.getMatrixXfMap (3, 4, 0).cast<double> ();
}

double
median (std::vector<double> values)
{
  std::sort (values.begin (), values.end ());
  return values.empty () ? 0.0 : values[values.size () / 2];
}

/** \brief A method, what it made of a cloud, and how long that took. */
struct Method
{
  std::string name;
  std::function<std::vector<pcl::SimplicialComplex::Triangle> ()> run;
  std::vector<pcl::SimplicialComplex::Triangle> triangles;
  std::vector<double> seconds;
};

/** \brief Runs a class on a cloud with a triangulation that it has not to make. */
template <typename Class>
std::vector<pcl::SimplicialComplex::Triangle>
trianglesOf (Class& object, const Cloud::Ptr& cloud, const Complex& complex, const Request& request)
{
  object.setInputCloud (cloud);
  object.setDelaunayComplex (complex);
  object.setNumberOfThreads (static_cast<unsigned int> (request.threads));
  pcl::SimplicialComplex shape;
  object.reconstruct (shape);
  return shape.triangles;
}

std::vector<Method>
methodsOf (const Cloud::Ptr& cloud, const Complex& complex, const Request& request)
{
  std::vector<Method> methods;
  methods.push_back ({"CoconeShape",
                      [&cloud, &complex, &request] {
                        Shapes object;
                        return trianglesOf (object, cloud, complex, request);
                      },
                      {},
                      {}});
  for (const Variant& variant : variantsOf (request.variants)) {
    char name[40];
    std::snprintf (name, sizeof (name), "fixed points %g:%d", variant.ratio, variant.votes);
    methods.push_back ({name,
                        [&cloud, &complex, &request, variant] {
                          FixedPoints object;
                          object.setCriticalRatio (variant.ratio);
                          object.setVotes (variant.votes);
                          return trianglesOf (object, cloud, complex, request);
                        },
                        {},
                        {}});
  }
  methods.push_back ({"advancing front", [&cloud] { return advancingFront (pointsOf (*cloud)); }, {}, {}});
  return methods;
}

Complex
triangulationOf (const Cloud::Ptr& cloud, const std::string& name)
{
  FixedPoints object;
  object.setInputCloud (cloud);
  pcl::SimplicialComplex shape;
  object.reconstruct (shape);
  pcl::manifold::apps::requireOk (name, object.getStatus ());
  return object.getDelaunayComplex ();
}

void
printSurfaceRow (const SurfaceMeasures& measures, std::int32_t samples)
{
  const pcl::manifold::SurfaceTopology& topology = measures.topology;
  std::printf (" %9.4f %9zu %6zu %6zu %7ld %5zu %8.3f %8.3f",
               100.0 * static_cast<double> (topology.vertices) / samples, topology.faces,
               topology.boundary_loops, topology.non_manifold_edges,
               static_cast<long> (topology.euler_characteristic), topology.components.size (),
               measures.smallest_angle, measures.percentile_angle);
  if (measures.hausdorff >= 0.0)
    std::printf (" %10.3g", measures.hausdorff);
  else
    std::printf (" %10s", "-");
}

void
printSurfaces (const Model& model, const Request& request)
{
  const Cloud::Ptr cloud = model.cloud.points ();
  const Complex complex = triangulationOf (cloud, model.cloud.name);
  std::vector<Method> methods = methodsOf (cloud, complex, request);
  for (int run = 0; run < request.runs; ++run)
    for (Method& method : methods) {
      const auto start = std::chrono::steady_clock::now ();
      method.triangles = method.run ();
      method.seconds.push_back (
        std::chrono::duration<double> (std::chrono::steady_clock::now () - start).count ());
    }
  const std::int32_t samples = complex->samples->size ();
  std::printf ("\n%s, %d samples\n%-20s %9s %9s %6s %6s %7s %5s %8s %8s %10s %8s %6s\n",
               model.cloud.name.c_str (), samples, "", "used %", "triangles", "loops", "n.m.", "Euler",
               "comp.", "min ang", "1 %", "Hausdorff", "s", "x");
  for (const Method& method : methods) {
    std::printf ("%-20s", method.name.c_str ());
    printSurfaceRow (measure (method.triangles, pointsOf (*cloud), model.shape ? &*model.shape : nullptr),
                     samples);
    std::printf (" %8.3f %6.2f\n", median (method.seconds),
                 median (method.seconds) / median (methods.front ().seconds));
    std::fflush (stdout);
  }
}

/** \brief How the fixed points do that the meshes of landmarks lead to. */
void
printIterations (const Model& model, const Request& request)
{
  const Cloud::Ptr cloud = model.cloud.points ();
  const Complex complex = triangulationOf (cloud, model.cloud.name);
  const std::int32_t samples = complex->samples->size ();
  std::printf ("\n%s, %d samples\n%4s %9s %10s %9s %9s %6s %6s %7s %5s %8s %8s %10s\n",
               model.cloud.name.c_str (), samples, "hops", "faces", "iterations", "used %", "triangles",
               "loops", "n.m.", "Euler", "comp.", "min ang", "1 %", "Hausdorff");
  for (const int hops : numbersOf (request.hops)) {
    pcl::GraphReconstruction<pcl::PointXYZ> landmarks;
    landmarks.setInputCloud (cloud);
    landmarks.setHops (hops);
    const auto mesh = pcl::make_shared<pcl::PolygonMesh> ();
    landmarks.reconstruct (*mesh);
    if (mesh->polygons.empty ()) {
      std::printf ("%4d %9s\n", hops, "none");
      continue;
    }
    FixedPoints object;
    object.setInitialMesh (mesh);
    const auto triangles = trianglesOf (object, cloud, complex, request);
    std::printf ("%4d %9zu %10d", hops, mesh->polygons.size (), object.getIterations ());
    printSurfaceRow (measure (triangles, pointsOf (*cloud), model.shape ? &*model.shape : nullptr), samples);
    std::printf ("\n");
    std::fflush (stdout);
  }
}

std::vector<Model>
modelsOf (const std::string& files, const std::string& shapes, const std::string& sizes, bool random)
{
  std::vector<Model> models;
  for (GraphModel& file : modelsOfFiles (files))
    models.push_back ({std::move (file), std::nullopt});
  for (const std::string& shape : splitAtCommas (shapes))
    for (GraphModel& cloud : generatedModels (shape, sizes, !random, 1))
      models.push_back ({std::move (cloud), generate::shapeByName (shape)});
  return models;
}

} // namespace

int
main (int argc, char** argv)
{
  using pcl::manifold::apps::CommandLine;
  CommandLine command_line (
    "benchmark_fixed_points",
    "Prints a table for clouds: FixedPointReconstruction beside CoconeShape, both on the same "
    "triangulation,\n"
    "and CGAL's advancing front, which makes its own; or the fixed points that meshes of landmarks lead to.");
  Request request;
  std::string files, shapes, sizes = "1e4";
  bool random = false;
  command_line.positional ("TABLE", "surfaces or iterations", request.table)
    .option ("files", "F,F", "clouds of finite points", files)
    .option ("shapes", "S,S", "generated clouds, as generate_cloud -list names them", shapes)
    .option ("sizes", "N,N", "numbers of their points", sizes)
    .flag ("random", "independent points instead of blue noise", random)
    .option ("variants", "R:V,R:V", "ratios and votes", request.variants)
    .option ("table-hops", "K,K-K", "hops between landmarks", request.hops)
    .option ("runs", "n", "runs of which the seconds are medians", request.runs, {1, 1000})
    .option ("threads", "n", "0 = all", request.threads, {0, 1024})
    .example ("benchmark_fixed_points surfaces -files kitten.xyz,bunny00.off -variants 0.313:1,0.6:2,0.8:3")
    .example ("benchmark_fixed_points surfaces -shapes sphere,torus,genus3 -sizes 1e4,1e5 -runs 1")
    .example ("benchmark_fixed_points iterations -files kitten.xyz,bunny00.off -table-hops 2-5");
  return pcl::manifold::apps::runApp (argc, argv, command_line, [&] {
    if (request.table != "surfaces" && request.table != "iterations")
      throw UsageError ("TABLE", "'" + request.table + "' is neither surfaces nor iterations");
    const std::vector<Model> models = modelsOf (files, shapes, sizes, random);
    if (models.empty ())
      throw UsageError ("-files", "there is no cloud: name some, or some -shapes");
    for (const Model& model : models)
      request.table == "surfaces" ? printSurfaces (model, request) : printIterations (model, request);
  });
}
