#include "common/parallel.h"
#include "complex/disjoint_sets.h"
#include "voronoi/dimension.h"
#include "voronoi/nearest_samples.h"
#include "voronoi/voronoi_cell.h"

#include <algorithm>
#include <array>

// The published label of a sample is that of its Voronoi cell: the rim of a surface looks like a curve, the
// skin of a solid like a surface. Which manifold the sample belongs to shows in the labels around it.

namespace pcl {
namespace manifold {

namespace {

// Nearest samples that are asked.
constexpr int NEIGHBORS = 10;
// On a curve nearly all of them are on the curve; beside the rim of a surface half of them are inside of it.
constexpr double CURVE_SHARE = 0.6;
// Fewer samples than this that look like the inside of a solid, next to each other, are noise on a surface or
// ends of curves: even a ball with four samples along its radius has more.
constexpr std::uint32_t MIN_SOLID = 24;
// On the skin of a solid about half of them are inside of it.
constexpr double SOLID_SHARE = 0.3;

struct Decision
{
  int dimension;
  bool boundary;
};

Decision
decide (int label, const std::array<int, 4>& count, int neighbors)
{
  if (count[1] >= CURVE_SHARE * neighbors)
    return {1, label != 1}; // the cell of an end point is long in every direction
  const int solid = count[3] + (label == 3 ? 1 : 0);
  if (solid >= SOLID_SHARE * neighbors && solid > 1)
    return {3, label != 3};
  if (label == 3 && count[1] > count[2])
    return {1, true};
  return {2, label == 1};
}

// Whether every Delaunay neighbour has the label of the sample: then there is nothing to decide.
bool
isUniform (const DelaunayComplex& complex, const std::vector<std::uint8_t>& labels, std::int32_t sample)
{
  bool uniform = true;
  VoronoiCell (complex, sample).forEachNeighbor ([&] (std::int32_t q) {
    uniform &= labels[q] == labels[sample];
  });
  return uniform;
}

// The published labels, with 2 for those 3 that are too few to be a solid.
std::vector<std::uint8_t>
withoutSmallSolids (const SampleDimensions& dimensions)
{
  const DelaunayComplex& complex = *dimensions.complex;
  std::vector<std::uint8_t> labels = dimensions.dimension;
  const auto samples = static_cast<std::uint32_t> (labels.size ());
  DisjointSets solids (samples);
  for (std::uint32_t i = 0; i < samples; ++i)
    if (labels[i] == 3)
      VoronoiCell (complex, static_cast<std::int32_t> (i)).forEachNeighbor ([&] (std::int32_t q) {
        if (labels[q] == 3)
          solids.join (i, static_cast<std::uint32_t> (q));
      });
  std::vector<std::uint32_t> sizes (samples, 0);
  for (std::uint32_t i = 0; i < samples; ++i)
    ++sizes[solids.find (i)];
  for (std::uint32_t i = 0; i < samples; ++i)
    if (labels[i] == 3 && sizes[solids.find (i)] < MIN_SOLID)
      labels[i] = 2;
  return labels;
}

} // namespace

void
decideManifoldDimensions (SampleDimensions& dimensions)
{
  const DelaunayComplex& complex = *dimensions.complex;
  dimensions.manifold_dimension = dimensions.dimension;
  dimensions.boundary.assign (dimensions.dimension.size (), 0);
  if (complex.affine_dimension < 2) {
    dimensions.boundary[complex.line.front ()] = dimensions.boundary[complex.line.back ()] =
      complex.affine_dimension == 1 ? 1 : 0;
    return;
  }
  const std::vector<std::uint8_t> labels = withoutSmallSolids (dimensions);
  const auto decideRange = [&] (std::size_t begin, std::size_t end) {
    NearestSamples nearest (complex);
    for (std::size_t i = begin; i < end; ++i) {
      const auto sample = static_cast<std::int32_t> (i);
      dimensions.manifold_dimension[i] = labels[i];
      if (isUniform (complex, labels, sample))
        continue;
      std::array<int, 4> count{};
      const std::vector<std::int32_t>& around = nearest.find (sample, NEIGHBORS);
      for (const std::int32_t q : around)
        ++count[labels[q]];
      const Decision decision = decide (labels[i], count, static_cast<int> (around.size ()));
      dimensions.manifold_dimension[i] = static_cast<std::uint8_t> (decision.dimension);
      dimensions.boundary[i] = decision.boundary ? 1 : 0;
    }
  };
  parallelRanges (labels.size (), decideRange);
}

} // namespace manifold
} // namespace pcl
