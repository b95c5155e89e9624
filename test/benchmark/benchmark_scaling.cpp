#include "bare_triangulation.h"
#include "peak_memory.h"
#include "shape_run.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>

// Prints how time and memory of COCONESHAPE grow from 10^4 points on: microseconds a tetrahedron, and the
// peak of memory beyond the points, beside those of the bare sequential triangulation of the same points.
//
//   benchmark_scaling [SHAPE] [NOISE] [THREADS] [LARGEST]
//
// SHAPE is sphere, torus or genus3; NOISE is in spacings (0 = a clean blue noise sample). The fastest of
// three runs.

namespace {

constexpr int RUNS = 3;

struct Measure
{
  double seconds = 1e300;
  double bytes = 0.0;
};

template <typename Run>
Measure
measure (const Run& run)
{
  Measure result;
  for (int i = 0; i < RUNS; ++i) {
    const std::size_t before = benchmark::resetPeakMemory ();
    result.seconds = std::min (result.seconds, run ());
    result.bytes = std::max (result.bytes, static_cast<double> (benchmark::peakMemory () - before));
  }
  return result;
}

} // namespace

int
main (int argc, char** argv)
{
  const std::string shape = argc > 1 ? argv[1] : "genus3";
  if (!benchmark::isShape (shape)) {
    std::printf ("usage: benchmark_scaling [sphere|torus|genus3] [NOISE in spacings] [THREADS] [LARGEST]\n");
    return shape == "-h" ? 0 : 2;
  }
  const double noise = argc > 2 ? std::atof (argv[2]) : 0.2;
  const auto threads = static_cast<unsigned int> (argc > 3 ? std::atoi (argv[3]) : 2);
  const double largest = argc > 4 ? std::atof (argv[4]) : 1e6;
  if (benchmark::resetPeakMemory () == 0)
    std::printf ("this system cannot reset its peak of memory: the columns of bytes say nothing\n");
  std::printf ("%s, noise %.2f spacings, %u threads\n", shape.c_str (), noise, threads);
  std::printf ("%9s %9s | us a cell: %6s %9s %11s | bytes a point: %6s %11s %6s\n", "points", "cells", "bare",
               "DIMENSION", "COCONESHAPE", "bare", "COCONESHAPE", "ratio");
  for (const double count : {1e4, 3e4, 1e5, 3e5, 1e6, 3e6}) {
    if (count > largest)
      break;
    const Eigen::Matrix3Xd points = benchmark::samplePoints (shape, static_cast<std::size_t> (count), noise);
    std::size_t cells = 0;
    double dimension = 1e300;
    const Measure bare = measure ([&] { return benchmark::bareTriangulation (points, false, cells); });
    const Measure whole = measure ([&] {
      const benchmark::ShapeRun run = benchmark::runShape (points, threads);
      dimension = std::min (dimension, run.dimension_seconds);
      return run.seconds;
    });
    const auto n = static_cast<double> (points.cols ());
    const double per_cell = 1e6 / static_cast<double> (cells);
    std::printf ("%9.0f %9zu |            %6.2f %9.2f %11.2f |                %6.0f %11.0f %6.2f\n", n, cells,
                 bare.seconds * per_cell, dimension * per_cell, whole.seconds * per_cell, bare.bytes / n,
                 whole.bytes / n, whole.bytes / bare.bytes);
    std::fflush (stdout);
  }
}
