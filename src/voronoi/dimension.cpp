#include "voronoi/dimension.h"

#include "common/parallel.h"
#include "voronoi/subpolytopes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl {
namespace manifold {

namespace {

// H1 / Hi, with the limits that unbounded subpolytopes stand for.
double
heightRatio (double h1, double hi)
{
  if (std::isinf (hi))
    return std::isinf (h1) ? 1.0 : 0.0;
  return hi > 0.0 ? std::min (h1 / hi, 1.0) : 1.0;
}

struct Decision
{
  int dimension;
  double confidence;
};

// The loop of DIMENSION. The confidence is the smallest distance of the ratios that it looked at from rho,
// each relative to the largest possible one on its side.
Decision
decide (const Eigen::Vector3d& heights, int affine_dimension, double rho)
{
  int i = affine_dimension;
  double confidence = 1.0;
  while (i > 1) {
    const double ratio = heightRatio (heights[0], heights[i - 1]);
    if (ratio >= rho) {
      confidence = std::min (confidence, rho < 1.0 ? (ratio - rho) / (1.0 - rho) : 0.0);
      break;
    }
    confidence = std::min (confidence, (rho - ratio) / rho);
    --i;
  }
  return {i, confidence};
}

// Samples on a line: V1 reaches half-way to the neighbours, everything orthogonal is unbounded.
void
fillLine (const DelaunayComplex& complex, SampleDimensions& result)
{
  const Eigen::Matrix3Xd& points = complex.samples->points;
  const std::vector<std::int32_t>& line = complex.line;
  Eigen::Vector3d tangent = points.col (line.back ()) - points.col (line.front ());
  tangent = tangent.norm () > 0.0 ? Eigen::Vector3d (tangent.normalized ())
                                  : Eigen::Vector3d (Eigen::Vector3d::UnitX ());
  for (std::size_t i = 0; i < line.size (); ++i) {
    const std::int32_t sample = line[i];
    result.dimension[sample] = static_cast<std::uint8_t> (complex.affine_dimension);
    result.confidence[sample] = 1.0f;
    double reach = std::numeric_limits<double>::infinity ();
    if (i > 0 && i + 1 < line.size ())
      reach = 0.5 * std::max ((points.col (sample) - points.col (line[i - 1])).norm (),
                              (points.col (line[i + 1]) - points.col (sample)).norm ());
    result.heights.col (sample) = Eigen::Vector3d (reach, std::numeric_limits<double>::infinity (),
                                                   std::numeric_limits<double>::infinity ());
    result.tangents.col (sample) = tangent;
    result.normals.col (sample) = tangent.unitOrthogonal ();
  }
}

} // namespace

SampleDimensions
computeDimensions (const std::shared_ptr<const DelaunayComplex>& complex, double rho)
{
  const auto n = static_cast<std::size_t> (complex->samples->size ());
  SampleDimensions result;
  result.complex = complex;
  result.dimension.resize (n);
  result.confidence.resize (n);
  result.heights.resize (3, n);
  result.normals.resize (3, n);
  result.tangents.resize (3, n);
  if (complex->affine_dimension < 2) {
    fillLine (*complex, result);
    return result;
  }
  parallelFor (n, [&] (std::size_t i) {
    const Subpolytopes polytopes =
      computeSubpolytopes (*complex, VoronoiCell (*complex, static_cast<std::int32_t> (i)));
    const Decision decision = decide (polytopes.heights, complex->affine_dimension, rho);
    result.dimension[i] = static_cast<std::uint8_t> (decision.dimension);
    result.confidence[i] = static_cast<float> (decision.confidence);
    result.heights.col (i) = polytopes.heights;
    result.normals.col (i) = polytopes.normal;
    result.tangents.col (i) = polytopes.tangent;
  });
  return result;
}

} // namespace manifold
} // namespace pcl
