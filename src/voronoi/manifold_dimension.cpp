#include "common/parallel.h"
#include "complex/disjoint_sets.h"
#include "voronoi/contradiction.h"
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
// Samples that look like the inside of a solid are one only where enough of them are next to each other (a
// ball with four samples along its radius has more) and one of them has no other neighbours: else they are
// noise on a surface or ends of curves.
constexpr std::uint32_t MIN_SOLID = 24;
// On the skin of a solid about half of them are inside of it.
constexpr double SOLID_SHARE = 0.3;
// Of those around an edge of a solid this many belong to it.
constexpr double SKIN_SHARE = 0.5;
// From the faces of a solid on to its edges, and from there on to its corners.
constexpr int SKIN_PASSES = 3;

struct Decision
{
  int dimension;
  bool boundary; ///< of a surface or a solid
};

Decision
decide (int label, const std::array<int, 4>& count, int neighbors)
{
  if (count[1] > CURVE_SHARE * neighbors)
    return {1, false};
  const int solid = count[3] + (label == 3 ? 1 : 0);
  if (solid >= SOLID_SHARE * neighbors && solid > 1)
    return {3, label != 3};
  if (label == 3 && count[1] > count[2])
    return {1, false}; // the cell of an end point may be long in every direction
  return {2, label == 1};
}

// Whether a sample of a curve is an end of it: opposite of the nearest sample, within 60 degrees, there is
// none.
bool
isEnd (const VoronoiCell& cell, const std::vector<std::int32_t>& nearest)
{
  const Eigen::Vector3d ahead = cell.relative (nearest.front ()).normalized ();
  return std::none_of (nearest.begin (), nearest.end (),
                       [&] (std::int32_t q) { return cell.relative (q).normalized ().dot (ahead) < -0.5; });
}

// Whether there is nothing to decide: every Delaunay neighbour has the label of the sample, or the sample is
// one of a surface with no more than two neighbours that are of a curve or a solid.
bool
isClear (const DelaunayComplex& complex, const std::vector<std::uint8_t>& labels, std::int32_t sample)
{
  // A neighbour is visited once for every cell at the edge to it, of which there are three or more.
  constexpr int VISITS_OF_THREE = 9;
  std::array<int, 4> visits{};
  VoronoiCell (complex, sample).forEachNeighbor ([&] (std::int32_t q) { ++visits[labels[q]]; });
  if (labels[sample] == 2)
    return visits[1] < VISITS_OF_THREE && visits[3] < VISITS_OF_THREE;
  return visits[labels[sample]] == visits[1] + visits[2] + visits[3];
}

// The published labels, with 2 for those 3 that are no solid.
std::vector<std::uint8_t>
withoutFalseSolids (const SampleDimensions& dimensions)
{
  const DelaunayComplex& complex = *dimensions.complex;
  std::vector<std::uint8_t> labels = dimensions.dimension;
  const auto samples = static_cast<std::uint32_t> (labels.size ());
  DisjointSets solids (samples);
  std::vector<std::uint8_t> inside (samples, 0); // has no other neighbours
  for (std::uint32_t i = 0; i < samples; ++i) {
    if (labels[i] != 3)
      continue;
    inside[i] = 1;
    VoronoiCell (complex, static_cast<std::int32_t> (i)).visitNeighbors ([&] (std::int32_t q) {
      if (labels[q] == 3)
        solids.join (i, static_cast<std::uint32_t> (q));
      else
        inside[i] = 0;
    });
  }
  std::vector<std::uint32_t> sizes (samples, 0);
  std::vector<std::uint8_t> has_inside (samples, 0);
  for (std::uint32_t i = 0; i < samples; ++i) {
    const std::uint32_t solid = solids.find (i);
    ++sizes[solid];
    has_inside[solid] |= inside[i];
  }
  for (std::uint32_t i = 0; i < samples; ++i) {
    const std::uint32_t solid = solids.find (i);
    if (labels[i] == 3 && (sizes[solid] < MIN_SOLID || !has_inside[solid]))
      labels[i] = 2;
  }
  return labels;
}

// Calls decideAt (sample, nearest) for all samples, nearest to find the nearest ones with; in parallel.
template <typename DecideAt>
void
forEachSample (const DelaunayComplex& complex, const DecideAt& decideAt)
{
  const auto samples = static_cast<std::size_t> (complex.samples->size ());
  parallelRanges (
    samples,
    [&] (std::size_t begin, std::size_t end) {
      NearestSamples nearest (complex);
      for (std::size_t i = begin; i < end; ++i)
        decideAt (static_cast<std::int32_t> (i), nearest);
    },
    std::max<std::size_t> (1024, samples / 64));
}

// At the edges and corners of a solid fewer of the nearest samples are inside of it, but most belong to it:
// samples that were taken for ones of a surface join it.
void
completeSkins (SampleDimensions& dimensions)
{
  const DelaunayComplex& complex = *dimensions.complex;
  const std::vector<std::uint8_t> decided = dimensions.manifold_dimension;
  forEachSample (complex, [&] (std::int32_t sample, NearestSamples& nearest) {
    if (decided[sample] != 2)
      return;
    bool beside_solid = false;
    VoronoiCell (complex, sample).visitNeighbors ([&] (std::int32_t q) { beside_solid |= decided[q] == 3; });
    if (!beside_solid)
      return;
    const std::vector<std::int32_t>& around = nearest.find (sample, NEIGHBORS);
    const auto solid =
      std::count_if (around.begin (), around.end (), [&] (std::int32_t q) { return decided[q] == 3; });
    if (static_cast<double> (solid) < SKIN_SHARE * static_cast<double> (around.size ()))
      return;
    dimensions.manifold_dimension[sample] = 3;
    dimensions.boundary[sample] = 1;
  });
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
  const std::vector<std::uint8_t> labels = withoutFalseSolids (dimensions);
  std::vector<std::uint8_t> contradicted (labels.size (), 0);
  forEachSample (complex, [&] (std::int32_t sample, NearestSamples& nearest) {
    dimensions.manifold_dimension[sample] = labels[sample];
    if (labels[sample] != 1 && isClear (complex, labels, sample))
      return;
    std::array<int, 4> count{};
    const std::vector<std::int32_t>& around = nearest.find (sample, NEIGHBORS);
    for (const std::int32_t q : around)
      ++count[labels[q]];
    const Decision decision = decide (labels[sample], count, static_cast<int> (around.size ()));
    dimensions.manifold_dimension[sample] = static_cast<std::uint8_t> (decision.dimension);
    dimensions.boundary[sample] = decision.boundary ? 1 : 0;
    if (decision.dimension != 1)
      return;
    const VoronoiCell cell (complex, sample);
    dimensions.boundary[sample] = isEnd (cell, around) ? 1 : 0;
    contradicted[sample] = isContradicted (dimensions, cell, around) ? 1 : 0;
  });
  dimensions.contradicted =
    static_cast<std::size_t> (std::count (contradicted.begin (), contradicted.end (), 1));
  if (std::find (labels.begin (), labels.end (), 3) != labels.end ())
    for (int pass = 0; pass < SKIN_PASSES; ++pass)
      completeSkins (dimensions);
}

} // namespace manifold
} // namespace pcl
