#include "evaluate_models.h"

#include <cloud_reader.h>

#include <generate/catalogue.h>
#include <generate/sampling.h>
#include <pcl/conversions.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <map>

namespace evaluate {

namespace {

using generate::Shape;
using must_show::Expected;

// Blue noise at this share of the feature size is what the theory of the method asks for.
constexpr double EPS = 0.1;

/** Adds samples of a shape: seeds 1 to `seeds`. */
void
addSamples (const std::string& shape_name, const std::string& kind, int seeds,
            const std::function<generate::LabelledCloud (const Shape&, std::uint64_t)>& sample, double used,
            std::vector<Model>& models)
{
  const Shape shape = generate::shapeByName (shape_name);
  const bool bounded = shape.topology.boundary_components == 0;
  for (int seed = 1; seed <= seeds; ++seed) {
    Model model;
    model.name = shape_name + " " + kind + " seed " + std::to_string (seed);
    model.points = [shape, sample, seed] {
      return must_show::pointsOf (sample (shape, static_cast<std::uint64_t> (seed)));
    };
    model.open = must_show::expectedOf (shape, used);
    // How a sheet is closed is up to the samples: what counts is that it is closed.
    if (bounded)
      model.watertight = must_show::closed (shape.topology.euler, std::min (used, 0.998));
    else
      model.watertight = must_show::closed (std::nullopt, 0.0);
    models.push_back (std::move (model));
  }
}

Expected
twoSided (std::size_t most_loops, double used)
{
  Expected expected;
  expected.most_loops = most_loops;
  expected.orientable = true;
  expected.used = used;
  return expected;
}

/** What is known of files, by their names without the extension. */
const std::map<std::string, Expected>&
knownFiles ()
{
  static const std::map<std::string, Expected> known = {
    {"knot1", must_show::closed (0, 1.0)},   {"kitten", must_show::closed (0, 1.0)},
    {"bunny00", must_show::closed (2, 1.0)}, {"bunny_35947", twoSided (2, 0.999)},
    {"dragon_435545", twoSided (8, 0.99)},
  };
  return known;
}

Eigen::Matrix3Xd
readPoints (const std::string& file)
{
  pcl::PointCloud<pcl::PointXYZ> cloud;
  pcl::fromPCLPointCloud2 (pcl::manifold::apps::readCloud (file).cloud, cloud);
  Eigen::Matrix3Xd points (3, static_cast<Eigen::Index> (cloud.size ()));
  for (std::size_t i = 0; i < cloud.size (); ++i)
    points.col (static_cast<Eigen::Index> (i)) = cloud[i].getVector3fMap ().cast<double> ();
  return points;
}

} // namespace

std::vector<Model>
generatedModels (int seeds, bool large)
{
  std::vector<Model> models;
  const auto blue = [] (double spacing) {
    return [spacing] (const Shape& shape, std::uint64_t seed) {
      return generate::blueNoise (shape, spacing, seed);
    };
  };
  const auto random = [] (std::size_t count) {
    return
      [count] (const Shape& shape, std::uint64_t seed) { return generate::uniform (shape, count, seed); };
  };
  for (const char* name : {"sphere", "torus", "genus3"})
    addSamples (
      name, "eps 0.1", seeds,
      [] (const Shape& shape, std::uint64_t seed) { return generate::epsilonSample (shape, EPS, seed); }, 1.0,
      models);
  for (const char* name : {"sphere", "torus", "genus3", "genus2", "ellipsoid", "knotted-tube"})
    addSamples (name, "random 10^4", seeds, random (10000), 0.998, models);
  for (const char* name : {"hemisphere", "annulus", "square", "terrain", "moebius", "cylinder"}) {
    const double spacing = generate::spacingFor (generate::shapeByName (name), 5000);
    addSamples (name, "blue", seeds, blue (spacing), 0.998, models);
    addSamples (
      name, "blue, no rim", seeds,
      [spacing] (const Shape& shape, std::uint64_t seed) {
        return generate::blueNoise (shape, spacing, seed, generate::Strata::IGNORED);
      },
      0.99, models);
    addSamples (name, "random 10^4", seeds, random (10000), 0.98, models);
  }
  if (large)
    for (const char* name : {"sphere", "torus", "genus3"}) {
      addSamples (name, "random 10^5", seeds, random (100000), 0.998, models);
      addSamples (
        name, "noisy 10^5", seeds,
        [] (const Shape& shape, std::uint64_t seed) {
          const double spacing = generate::spacingFor (shape, 100000);
          generate::LabelledCloud cloud = generate::blueNoise (shape, spacing, seed);
          generate::addNoise (cloud, 0.2 * spacing, seed + 1000);
          return cloud;
        },
        0.998, models);
    }
  return models;
}

std::vector<Model>
modelsOfFolder (const std::string& folder)
{
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator (folder)) {
    const std::string extension = entry.path ().extension ().string ();
    if (entry.is_regular_file () &&
        (extension == ".off" || extension == ".pcd" || extension == ".ply" || extension == ".xyz"))
      files.push_back (entry.path ());
  }
  std::sort (files.begin (), files.end ());
  std::vector<Model> models;
  for (const auto& file : files) {
    Model model;
    model.name = file.filename ().string ();
    model.points = [file] { return readPoints (file.string ()); };
    const auto known = knownFiles ().find (file.stem ().string ());
    model.watertight = must_show::closed (std::nullopt, 0.998);
    if (known != knownFiles ().end ()) {
      model.open = known->second;
      model.watertight.euler = known->second.euler;
    }
    models.push_back (std::move (model));
  }
  return models;
}

} // namespace evaluate
