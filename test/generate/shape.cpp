#include <generate/random.h>
#include <generate/shape.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace generate {

namespace {

/** Integral of a density over the unit interval, square or cube: composite Gauss-Legendre with two nodes a
 * cell, of fourth order, and of much higher order where the density is periodic. */
double
integrate (int dimension, const std::function<double (const Eigen::Vector3d&)>& density)
{
  const int cells = dimension == 3 ? 24 : 128;
  const double offset = 0.5 / std::sqrt (3.0);
  const auto node = [cells, offset] (int i) {
    return ((i / 2) + 0.5 + (i % 2 == 0 ? -offset : offset)) / cells;
  };
  const int nodes = 2 * cells;
  double sum = 0.0;
  for (int i = 0; i < nodes; ++i)
    for (int j = 0; j < (dimension > 1 ? nodes : 1); ++j)
      for (int k = 0; k < (dimension > 2 ? nodes : 1); ++k)
        sum += density ({node (i), node (j), node (k)});
  return sum / std::pow (nodes, dimension);
}

} // namespace

double
Shape::measure () const
{
  double sum = 0.0;
  for (const Patch& patch : patches)
    sum += patch.measure;
  return sum;
}

double
Shape::depth (const Eigen::Vector3d& p) const
{
  if (dimension < 3)
    return 0.0;
  double smallest = std::numeric_limits<double>::infinity ();
  for (const Shape& skin : strata)
    smallest = std::min (smallest, skin.nearest (p).distance);
  return smallest;
}

UniformDraw::UniformDraw (const Shape& shape) : shape_ (shape)
{
  double sum = 0.0;
  cumulated_.reserve (shape.patches.size ());
  for (const Patch& patch : shape.patches)
    cumulated_.push_back (sum += patch.measure);
}

Eigen::Vector3d
UniformDraw::operator() (Random& random) const
{
  const double where = random.uniform () * cumulated_.back ();
  const auto found = std::upper_bound (cumulated_.begin (), cumulated_.end () - 1, where);
  const std::size_t patch = static_cast<std::size_t> (found - cumulated_.begin ());
  const double bound = shape_.patches[patch].density_bound;
  Eigen::Vector3d u;
  do
    u = random.cube ();
  while (random.uniform () * bound >= shape_.density (patch, u));
  return shape_.point (patch, u);
}

Shape
moved (const Shape& shape, const Eigen::Isometry3d& motion)
{
  Shape result = shape;
  result.point = [inner = shape.point, motion] (std::size_t patch,
                                                const Eigen::Vector3d& u) -> Eigen::Vector3d {
    return motion * inner (patch, u);
  };
  result.nearest = [inner = shape.nearest, motion] (const Eigen::Vector3d& p) {
    const Nearest found = inner (motion.inverse () * p);
    return Nearest{motion * found.point, motion.linear () * found.normal, found.distance};
  };
  for (Shape& stratum : result.strata)
    stratum = moved (stratum, motion);
  return result;
}

Shape
moved (const Shape& shape, const Eigen::Vector3d& offset)
{
  return moved (shape, Eigen::Isometry3d (Eigen::Translation3d (offset)));
}

Shape
parametric (const std::string& name, int dimension, const Topology& topology, const Eigen::Vector3d& stretch,
            double density_bound, std::function<Eigen::Vector3d (const Eigen::Vector3d& u)> point,
            std::function<double (const Eigen::Vector3d& u)> density)
{
  Shape shape;
  shape.name = name;
  shape.dimension = dimension;
  shape.topology = topology;
  shape.patches = {{integrate (dimension, density), density_bound}};
  shape.extent = [stretch] (std::size_t, const Eigen::Vector3d&,
                            const Eigen::Vector3d& size) -> Eigen::Vector3d {
    return stretch.cwiseProduct (size);
  };
  shape.point = [point = std::move (point)] (std::size_t, const Eigen::Vector3d& u) { return point (u); };
  shape.density = [density = std::move (density)] (std::size_t, const Eigen::Vector3d& u) {
    return density (u);
  };
  return shape;
}

Shape
isolatedPoints (const std::string& name, const std::vector<Eigen::Vector3d>& points)
{
  const int count = static_cast<int> (points.size ());
  Shape shape;
  shape.name = name;
  shape.dimension = 0;
  shape.topology = {count, 0, true};
  shape.patches.assign (points.size (), {1.0, 1.0});
  shape.extent = [] (std::size_t, const Eigen::Vector3d&, const Eigen::Vector3d&) -> Eigen::Vector3d {
    return Eigen::Vector3d::Zero ();
  };
  shape.point = [points] (std::size_t patch, const Eigen::Vector3d&) { return points[patch]; };
  shape.density = [] (std::size_t, const Eigen::Vector3d&) { return 1.0; };
  shape.nearest = [points] (const Eigen::Vector3d& p) {
    const auto nearer = [&p] (const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
      return (a - p).squaredNorm () < (b - p).squaredNorm ();
    };
    const Eigen::Vector3d best = *std::min_element (points.begin (), points.end (), nearer);
    return Nearest{best, Eigen::Vector3d::UnitZ (), (best - p).norm ()};
  };
  return shape;
}

} // namespace generate
