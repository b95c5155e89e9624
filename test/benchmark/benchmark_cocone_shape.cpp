#include "bare_triangulation.h"
#include "shape_run.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

// Prints how long DIMENSION and COCONESHAPE take as multiples of the bare triangulation of the same points in
// the same run, and the share of every stage.
//
//   benchmark_cocone_shape [SHAPE] [POINTS] [NOISE] [THREADS] [RUNS]
//
// SHAPE is sphere, torus or genus3; NOISE is in spacings (0 = a clean blue noise sample). The triangulation
// is the faster of CGAL's sequential and parallel insertion; medians over the runs.

namespace {

double
median (std::vector<double> values)
{
  std::sort (values.begin (), values.end ());
  return values[values.size () / 2];
}

} // namespace

int
main (int argc, char** argv)
{
  const std::string shape = argc > 1 ? argv[1] : "genus3";
  if (!benchmark::isShape (shape)) {
    std::printf (
      "usage: benchmark_cocone_shape [sphere|torus|genus3] [POINTS] [NOISE in spacings] [THREADS] [RUNS]\n");
    return shape == "-h" ? 0 : 2;
  }
  const auto count = static_cast<std::size_t> (argc > 2 ? std::atof (argv[2]) : 1e5);
  const double noise = argc > 3 ? std::atof (argv[3]) : 0.2;
  const auto threads = static_cast<unsigned int> (argc > 4 ? std::atoi (argv[4]) : 2);
  const int runs = argc > 5 ? std::atoi (argv[5]) : 3;

  const Eigen::Matrix3Xd points = benchmark::samplePoints (shape, count, noise);
  std::vector<double> sequential;
  std::vector<double> parallel;
  std::vector<double> dimension;
  std::vector<double> total;
  std::vector<std::vector<double>> stages;
  std::vector<std::string> names;
  std::size_t cells = 0;
  for (int run = 0; run < runs; ++run) {
    sequential.push_back (benchmark::bareTriangulation (points, false, cells));
    parallel.push_back (threads > 1 ? benchmark::bareTriangulation (points, true, cells)
                                    : sequential.back ());
    const benchmark::ShapeRun result = benchmark::runShape (points, threads);
    total.push_back (result.seconds);
    stages.resize (result.stages.size ());
    names.clear ();
    for (std::size_t i = 0; i < result.stages.size (); ++i) {
      stages[i].push_back (result.stages[i].seconds);
      names.push_back (result.stages[i].name);
    }
    dimension.push_back (result.dimension_seconds);
  }
  const double bare = std::min (median (sequential), median (parallel));
  std::printf ("%s, %ld points, noise %.2f spacings, %u threads, %.1f cells a point\n", shape.c_str (),
               static_cast<long> (points.cols ()), noise, threads,
               static_cast<double> (cells) / static_cast<double> (points.cols ()));
  std::printf ("bare triangulation: sequential %.3f s, parallel %.3f s\n", median (sequential),
               median (parallel));
  std::printf ("DIMENSION   %.3f s = %.2f times the faster\n", median (dimension), median (dimension) / bare);
  std::printf ("COCONESHAPE %.3f s = %.2f times the faster\n", median (total), median (total) / bare);
  for (std::size_t i = 0; i < names.size (); ++i)
    std::printf ("  %-24s %.3f s = %.2f\n", names[i].c_str (), median (stages[i]), median (stages[i]) / bare);
}
