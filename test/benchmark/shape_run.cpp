#include "shape_run.h"

#include "generate/closed_surfaces.h"
#include "generate/implicit.h"
#include "generate/sampling.h"

#include <pcl/manifold/reconstruct_shape.h>

#include <chrono>
#include <cstdio>

namespace benchmark {

bool
isShape (const std::string& name)
{
  return name == "sphere" || name == "torus" || name == "genus3";
}

Eigen::Matrix3Xd
samplePoints (const std::string& name, std::size_t count, double noise)
{
  const generate::Shape shape = name == "sphere"  ? generate::sphere ()
                                : name == "torus" ? generate::torus ()
                                                  : generate::genus3 ();
  const double spacing = generate::spacingFor (shape, count);
  generate::LabelledCloud cloud = generate::blueNoise (shape, spacing, 1);
  if (noise > 0.0)
    generate::addNoise (cloud, noise * spacing, 2);
  Eigen::Matrix3Xd points (3, static_cast<Eigen::Index> (cloud.size ()));
  for (std::size_t i = 0; i < cloud.size (); ++i)
    points.col (i) = cloud.points[i].cast<float> ().cast<double> (); // as PCL's points are
  return points;
}

ShapeRun
runShape (const Eigen::Matrix3Xd& points, unsigned int threads)
{
  pcl::manifold::ShapeParameters parameters;
  parameters.dimension.threads = threads;
  pcl::manifold::StageLog log;
  std::shared_ptr<const pcl::manifold::SampleDimensions> dimensions;
  pcl::SimplicialComplex shape;
  const auto start = std::chrono::steady_clock::now ();
  const auto status = pcl::manifold::reconstructShape (points, {}, pcl::manifold::FLOAT_RESOLUTION,
                                                       parameters, log, dimensions, shape);
  ShapeRun run;
  run.seconds = std::chrono::duration<double> (std::chrono::steady_clock::now () - start).count ();
  run.stages = log.stages ();
  for (const pcl::manifold::Stage& stage : run.stages) {
    if (stage.name == "color cells")
      break;
    run.dimension_seconds += stage.seconds;
  }
  if (status != pcl::manifold::Status::OK)
    std::printf ("failed: %s\n", pcl::manifold::toString (status));
  return run;
}

} // namespace benchmark
