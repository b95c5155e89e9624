#include "bare_triangulation.h"
#include "dimension_clouds.h"
#include "dimension_methods.h"
#include "pca_curves.h"

#include <app_main.h>
#include <command_line.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <map>
#include <string>
#include <utility>

// Detects the dimension of clouds whose truth is known, with nothing set, and beside it by what else there
// is: the published method at one level, and the eigenvalues of neighbours.
//
//   evaluate_dimensions -generated 1 -data FOLDER -only frame

namespace {

using namespace evaluate;

constexpr int LEVELS = 10;

struct Options
{
  unsigned int threads = 0;
  bool alone = false;
};

void
printScore (const char* method, const CurveScore& score, double dimension, double seconds, double bare)
{
  const auto percent = [] (double share) { return 100.0 * share; };
  std::printf ("  %-38.38s", method);
  if (dimension >= 0.0)
    std::printf (" %8.2f", percent (dimension));
  else
    std::printf (" %8s", "-");
  std::printf (" %8.2f %8.2f %8.2f %8.3f", percent (score.accuracy ()), percent (score.precision ()),
               percent (score.recall ()), score.f1 ());
  if (seconds > 0.0)
    std::printf (" %8.2f", seconds / bare);
  std::printf ("\n");
  std::fflush (stdout);
}

/** The share of the points that have their true dimension, or -1 where that is not known. */
double
rightDimensions (const LabelledPoints& truth, const Answers& answers)
{
  if (truth.dimension.empty () || answers.dimension.empty ())
    return -1.0;
  std::size_t asked = 0, right = 0;
  for (std::size_t i = 0; i < truth.dimension.size (); ++i)
    if (truth.curve[i] != Curve::NOT_ASKED) {
      ++asked;
      right += truth.dimension[i] == answers.dimension[i] ? 1 : 0;
    }
  return asked == 0 ? -1.0 : static_cast<double> (right) / static_cast<double> (asked);
}

/** What became of the things of every class. */
void
printClasses (const LabelledPoints& truth, const Answers& answers)
{
  constexpr double FEWEST = 50.0;
  std::map<std::uint32_t, std::array<double, 4>> counts;
  for (std::size_t i = 0; i < answers.dimension.size (); ++i)
    ++counts[truth.classes[i]][answers.dimension[i] & 3U];
  for (const auto& [name, count] : counts) {
    const double all = count[0] + count[1] + count[2] + count[3];
    if (all >= FEWEST)
      std::printf ("    class %3u: %8.0f points, curve %6.2f %%, surface %6.2f %%, solid %6.2f %%\n", name,
                   all, 100.0 * count[1] / all, 100.0 * count[2] / all, 100.0 * count[3] / all);
  }
}

/** The best of several levels, by hindsight, whichever of the two labels is better there. */
void
printBestLevel (const LabelledPoints& truth, double spacing, unsigned int threads, double bare)
{
  Answers best;
  CurveScore best_score;
  double best_distance = 0.0;
  for (int power = 1; power <= LEVELS; ++power) {
    const double distance = spacing * std::pow (std::sqrt (2.0), power);
    LevelAnswers level = detectAtOneLevel (truth.points, distance, threads);
    for (Answers* const answers : {&level.manifold, &level.published}) {
      const CurveScore score = scoreOf (truth, *answers);
      if (!best.dimension.empty () && score.f1 () <= best_score.f1 ())
        continue;
      best = std::move (*answers);
      best_score = score;
      best_distance = distance;
    }
  }
  std::array<char, 64> name{};
  std::snprintf (name.data (), name.size (), "best single level, -thin-distance %.3g", best_distance);
  printScore (name.data (), best_score, rightDimensions (truth, best), best.seconds, bare);
}

void
evaluateCloud (const DimensionCloud& cloud, const Options& options)
{
  const LabelledPoints truth = cloud.make ();
  std::size_t cells = 0;
  const double bare = benchmark::bareTriangulation (truth.points, options.threads != 1, cells);
  std::printf ("%s: %td points, bare triangulation %.2f s\n", cloud.name.c_str (),
               static_cast<std::ptrdiff_t> (truth.points.cols ()), bare);

  const Answers answers = detectAtAllScales (truth.points, options.threads);
  printScore ("nothing set", scoreOf (truth, answers), rightDimensions (truth, answers), answers.seconds,
              bare);
  if (cloud.vertical)
    printScore ("  upright curves", scoreOf (truth, answers, true), -1.0, 0.0, bare);
  if (!options.alone) {
    const double spacing = medianSpacing (truth.points);
    const LevelAnswers level = detectAtOneLevel (truth.points, 0.0, options.threads);
    for (const auto& [name, found] : {std::pair ("single level, as published", &level.published),
                                      std::pair ("single level, of the manifold", &level.manifold)})
      printScore (name, scoreOf (truth, *found), rightDimensions (truth, *found), found->seconds, bare);
    printBestLevel (truth, spacing, options.threads, bare);
    const Answers pca = pcaOfLeastEntropy (truth.points);
    printScore ("PCA of least entropy", scoreOf (truth, pca), rightDimensions (truth, pca), pca.seconds,
                bare);
    const TunedPca tuned = tunePca (truth, spacing);
    std::array<char, 64> name{};
    std::snprintf (name.data (), name.size (), "PCA tuned: radius %.3g, linearity %.2f", tuned.radius,
                   tuned.linearity);
    printScore (name.data (), tuned.score, -1.0, 0.0, bare);
  }
  printClasses (truth, answers);
}

} // namespace

int
main (int argc, char** argv)
{
  using namespace pcl::manifold::apps;
  int seeds = 0, threads = 0;
  std::string data, only;
  Options options;
  CommandLine command_line ("evaluate_dimensions",
                            "Detects the dimension of clouds whose truth is known, and says how well. "
                            "Columns, in percent but for the last "
                            "two:\n"
                            "points with their true dimension; points rightly told curve or not; precision, "
                            "recall and F1 of curves;\n"
                            "seconds as a multiple of a bare Delaunay triangulation of the same points.");
  command_line.option ("generated", "n", "this many samples of every generated scene", seeds, {0, 1000})
    .option ("data", "FOLDER", "the labelled clouds in a folder", data)
    .option ("only", "TEXT", "only clouds whose name has this in it", only)
    .flag ("alone", "leave out what is there to compare with", options.alone)
    .option ("threads", "n", "0 = all", threads, {0, 1024})
    .example ("evaluate_dimensions -generated 1 -only frame");
  return runApp (argc, argv, command_line, [&] {
    options.threads = static_cast<unsigned int> (threads);
    std::vector<DimensionCloud> clouds = generatedClouds (seeds);
    if (!data.empty ())
      for (DimensionCloud& cloud : labelledFiles (data))
        clouds.push_back (std::move (cloud));
    std::printf ("%-40s %8s %8s %8s %8s %8s %8s\n", "", "dim. %", "accur. %", "prec. %", "recall %", "F1",
                 "x bare");
    for (const DimensionCloud& cloud : clouds) {
      if (cloud.name.find (only) == std::string::npos)
        continue;
      try {
        evaluateCloud (cloud, options);
      } catch (const std::exception& error) {
        std::printf ("%s: not evaluated: %s\n", cloud.name.c_str (), error.what ());
      }
    }
  });
}
