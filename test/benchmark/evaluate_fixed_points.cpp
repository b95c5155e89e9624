#include "../test_must_show_fixed_points.h"

#include <app_main.h>

#include <cstdio>

// The published guarantee of FixedPointReconstruction on many samples; -h says how.

namespace {

using namespace must_show;

/** \return the number of samples whose reconstruction is not what the theory says */
int
evaluateSurface (const std::string& name, int seeds, unsigned int threads)
{
  const SmoothSurface surface = smoothSurface (name);
  const Closeness bounds = provedBounds (GUARANTEED_EPS);
  Closeness worst;
  double samples = 0.0;
  double seconds = 0.0;
  int wrong = 0;
  for (int seed = 1; seed <= seeds; ++seed) {
    const Eigen::Matrix3Xd points = surface.sample (GUARANTEED_EPS, static_cast<std::uint64_t> (seed));
    const FixedPointEvaluation evaluation =
      reconstructFixedPoint (points, pcl::manifold::CriticalPointParameters (), threads);
    Closeness closeness;
    std::string complaints = guaranteeComplaints (surface, points, evaluation, closeness);
    if (complaints.empty ())
      complaints = sausageComplaints (surface, points, evaluation, static_cast<std::uint64_t> (seed));
    if (!complaints.empty ()) {
      std::printf ("%s, seed %d: %s\n", name.c_str (), seed, complaints.c_str ());
      ++wrong;
    }
    worst.distance = std::max (worst.distance, closeness.distance);
    worst.angle = std::max (worst.angle, closeness.angle);
    samples += static_cast<double> (evaluation.surface.samples);
    seconds += evaluation.surface.seconds;
  }
  std::printf ("%-12s %6d %6d %9.0f %10.5f %10.5f %8.2f %8.2f %8.2f\n", name.c_str (), seeds, wrong,
               samples / seeds, worst.distance, bounds.distance, worst.angle * 180.0 / M_PI,
               bounds.angle * 180.0 / M_PI, seconds);
  std::fflush (stdout);
  return wrong;
}

} // namespace

int
main (int argc, char** argv)
{
  using pcl::manifold::apps::CommandLine;
  int seeds = 200;
  int threads = 0;
  std::string only;
  int wrong = 0;
  CommandLine command_line (
    "evaluate_fixed_points",
    "Reconstructs 0.143-samples of smooth closed surfaces with the published constant, and says which are\n"
    "not homeomorphic to the surface, not within the complex, or further away than Theorem 13 allows; and "
    "which\n"
    "rough meshes in the sausage around it, two for every sample, do not lead to a fixed point in the "
    "complex.");
  command_line.option ("seeds", "n", "samples of every surface", seeds, {1, 1000000})
    .option ("only", "TEXT", "only surfaces whose name has this in it", only)
    .option ("threads", "n", "0 = all", threads, {0, 1024})
    .example ("evaluate_fixed_points -seeds 200");
  const int status = pcl::manifold::apps::runApp (argc, argv, command_line, [&] {
    std::printf ("%-12s %6s %6s %9s %10s %10s %8s %8s %8s\n", "surface", "seeds", "wrong", "samples",
                 "distance", "allowed", "degrees", "allowed", "s");
    for (const std::string& name : smoothSurfaceNames ())
      if (name.find (only) != std::string::npos)
        wrong += evaluateSurface (name, seeds, static_cast<unsigned int> (threads));
    std::printf ("%d are not as they should be\n", wrong);
  });
  return status != 0 ? status : wrong > 0 ? 1 : 0;
}
