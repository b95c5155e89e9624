#include "evaluate_models.h"

#include <app_main.h>

#include <algorithm>
#include <cstdio>
#include <exception>

// Reconstructs many clouds, open and watertight, and prints a table of what came out; a row that does not
// keep to what is asked ends in what is wrong.
//
//   evaluate_models -generated 5 -data FOLDER -only sphere

namespace {

using namespace evaluate;

// Smaller files are sketches, not samples of a surface.
constexpr Eigen::Index MIN_POINTS = 1000;

void
printHeader ()
{
  std::printf ("%-34s %4s %8s %6s %6s %8s %8s %6s %6s %5s %5s %8s %5s %7s %6s %7s  %s\n", "model", "",
               "samples", "dim 1", "dim 3", "used %", "triangl.", "edges", "tetra.", "loops", "n.m.", "Euler",
               "comp.", "1-sided", "genus", "s", "complaints");
}

/** \return whether there is nothing to complain about */
bool
printRow (const std::string& name, const char* mode, const must_show::Evaluation& row,
          const must_show::Expected& expected)
{
  const auto& surface = row.topology.surface;
  std::size_t of_dimension[4] = {};
  if (row.dimensions)
    for (const std::uint8_t dimension : row.dimensions->manifold_dimension)
      ++of_dimension[dimension & 3];
  const auto one_sided = std::count_if (surface.components.begin (), surface.components.end (),
                                        [] (const auto& component) { return !component.orientable; });
  const std::string complaints = row.complaints (expected);
  std::printf (
    "%-34.34s %4s %8zu %6zu %6zu %8.3f %8zu %6zu %6zu %5zu %2zu/%-2zu %8ld %5zu %7ld %6d %7.2f  %s\n",
    name.c_str (), mode, row.samples, of_dimension[1], of_dimension[3], 100.0 * row.used (), surface.faces,
    row.topology.curve.edges, row.topology.solid.tetrahedra, surface.boundary_loops,
    surface.non_manifold_edges, surface.non_manifold_vertices,
    static_cast<long> (surface.euler_characteristic), surface.components.size (),
    static_cast<long> (one_sided), surface.components.empty () ? -1 : surface.components.front ().genus,
    row.seconds, complaints.c_str ());
  std::fflush (stdout);
  return complaints.empty ();
}

/** \return the number of rows that something is wrong with */
int
evaluateModel (const Model& model, unsigned int threads)
{
  const Eigen::Matrix3Xd points = model.points ();
  if (points.cols () < MIN_POINTS)
    return 0;
  const must_show::Evaluation open = must_show::reconstruct (points, false, nullptr, threads);
  const must_show::Evaluation watertight = must_show::reconstruct (points, true, open.dimensions, threads);
  return !printRow (model.name, "open", open, model.open) +
         !printRow (model.name, "shut", watertight, model.watertight);
}

} // namespace

int
main (int argc, char** argv)
{
  using namespace pcl::manifold::apps;
  int seeds = 0;
  bool large = false;
  std::string data;
  std::string only;
  int threads = 0;
  CommandLine command_line ("evaluate_models",
                            "Reconstructs many clouds and says which results are not as they should be.");
  command_line.option ("generated", "n", "this many samples of every generated shape", seeds, {0, 1000})
    .flag ("large", "add generated samples of 10^5 points", large)
    .option ("data", "FOLDER", "the meshes and clouds in a folder, of at least 1000 points", data)
    .option ("only", "TEXT", "only models whose name has this in it", only)
    .option ("threads", "n", "0 = all", threads, {0, 1024})
    .example ("evaluate_models -generated 5 -only torus");
  return runApp (argc, argv, command_line, [&] {
    std::vector<Model> models = generatedModels (seeds, large);
    if (!data.empty ())
      for (Model& model : modelsOfFolder (data))
        models.push_back (std::move (model));
    printHeader ();
    int wrong = 0;
    int rows = 0;
    for (const Model& model : models) {
      if (model.name.find (only) == std::string::npos)
        continue;
      try {
        wrong += evaluateModel (model, static_cast<unsigned int> (threads));
        rows += 2;
      } catch (const std::exception& error) {
        std::printf ("%-34.34s not evaluated: %s\n", model.name.c_str (), error.what ());
      }
    }
    std::printf ("%d of %d rows are not as they should be\n", wrong, rows);
  });
}
