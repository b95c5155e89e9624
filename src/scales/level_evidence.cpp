#include "scales/level_evidence.h"

#include "common/parallel.h"
#include "complex/disjoint_sets.h"
#include "scales/local_spread.h"
#include "voronoi/nearest_samples.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pcl {
namespace manifold {

namespace {

// Of the samples of a curve two on either side are within so many spacings.
constexpr double REACH = 2.5;
// More neighbours than these are no curve anyway, and tell enough of a plane.
constexpr int NEIGHBORS = 16;
// (sigma1 - sigma2) / sigma1 of the samples around one of a curve: surely, and perhaps.
constexpr double SURELY_LINEAR = 0.7;
constexpr double PERHAPS_LINEAR = 0.4;
// sigma3 / sigma2 of the samples around one of a surface is smaller, of at least so many.
constexpr double FLATNESS = 0.5;
constexpr int FEWEST_OF_PLANE = 4;
// Neighbours on a curve are within 37 degrees of each other's direction.
constexpr double ALONG = 0.8;
// A piece of a curve is about three spacings long, and this share of it is sure.
constexpr double SHORTEST = 2.9;
constexpr double SURE_SHARE = 0.5;
constexpr std::uint32_t FEWEST_SURE = 2;

enum Grade : std::uint8_t
{
  NO_CURVE,
  DOUBTFUL,
  SURE
};

// The spread of the samples within reach of each.
struct Spread
{
  Eigen::Matrix3Xf direction;
  std::vector<std::uint8_t> grade, flat;
  std::vector<std::array<std::int32_t, NEIGHBORS>> near; // ended by -1
};

Spread
spreadOf (const SampleDimensions& dimensions, double spacing)
{
  const DelaunayComplex& complex = *dimensions.complex;
  const Eigen::Matrix3Xd& points = complex.samples->points;
  const auto n = static_cast<std::size_t> (points.cols ());
  Spread spread;
  spread.direction = Eigen::Matrix3Xf::Zero (3, points.cols ());
  spread.grade.assign (n, NO_CURVE);
  spread.flat.assign (n, 0);
  spread.near.resize (n);
  const double reach = REACH * spacing;
  const auto look = [&] (std::size_t begin, std::size_t end) {
    NearestSamples nearest (complex);
    for (std::size_t i = begin; i < end; ++i) {
      const auto sample = static_cast<std::int32_t> (i);
      std::array<std::int32_t, NEIGHBORS>& near = spread.near[i];
      LocalSpread around;
      near.fill (-1);
      for (const std::int32_t q : nearest.find (sample, NEIGHBORS)) {
        const Eigen::Vector3d to = points.col (q) - points.col (sample);
        if (to.norm () > reach)
          break;
        near[around.count ()] = q;
        around.add (to);
      }
      const int count = around.count ();
      if (count == 0)
        continue;
      around.solve ();
      spread.direction.col (sample) = around.direction ().cast<float> ();
      const double linear = around.linearity ();
      const bool published = dimensions.dimension[i] == 1;
      if (dimensions.manifold_dimension[i] == 1 || (published && count >= 2 && linear > SURELY_LINEAR))
        spread.grade[i] = SURE;
      else if (published || (count >= 2 && linear > PERHAPS_LINEAR))
        spread.grade[i] = DOUBTFUL;
      spread.flat[i] = count >= FEWEST_OF_PLANE && around.sigma ()[0] < FLATNESS * around.sigma ()[1] ? 1 : 0;
    }
  };
  parallelRanges (n, look, std::max<std::size_t> (1024, n / 64));
  return spread;
}

// Whether two samples of curves follow each other.
bool
isAlong (const Eigen::Matrix3Xd& points, const Spread& spread, std::int32_t a, std::int32_t b)
{
  const Eigen::Vector3f to = (points.col (b) - points.col (a)).normalized ().cast<float> ();
  return std::abs (to.dot (spread.direction.col (a))) > ALONG &&
         std::abs (to.dot (spread.direction.col (b))) > ALONG;
}

// Numbers the pieces of curves and measures them.
void
joinPieces (const Eigen::Matrix3Xd& points, const Spread& spread, double spacing, LevelEvidence& evidence)
{
  const auto n = static_cast<std::uint32_t> (points.cols ());
  evidence.piece.assign (n, -1);
  evidence.length.assign (n, 0.0f);
  DisjointSets sets (n);
  for (std::uint32_t i = 0; i < n; ++i)
    if (spread.grade[i] != NO_CURVE)
      for (const std::int32_t q : spread.near[i])
        if (q >= 0 && spread.grade[q] != NO_CURVE &&
            isAlong (points, spread, static_cast<std::int32_t> (i), q))
          sets.join (i, static_cast<std::uint32_t> (q));

  std::vector<std::uint32_t> set_of;
  const std::uint32_t count = sets.number (set_of);
  std::vector<std::uint32_t> members (count, 0), sure (count, 0);
  Eigen::Matrix3Xd mean = Eigen::Matrix3Xd::Zero (3, count);
  for (std::uint32_t i = 0; i < n; ++i) {
    ++members[set_of[i]];
    sure[set_of[i]] += spread.grade[i] == SURE ? 1 : 0;
    mean.col (set_of[i]) += points.col (i);
  }
  for (std::uint32_t set = 0; set < count; ++set)
    mean.col (set) /= members[set];
  std::vector<double> half (count, 0.0);
  for (std::uint32_t i = 0; i < n; ++i)
    half[set_of[i]] = std::max (half[set_of[i]], (points.col (i) - mean.col (set_of[i])).norm ());

  std::vector<std::int32_t> number (count, -1);
  for (std::uint32_t set = 0; set < count; ++set)
    if (sure[set] >= FEWEST_SURE && sure[set] >= SURE_SHARE * members[set] &&
        2.0 * half[set] >= SHORTEST * spacing)
      number[set] = evidence.pieces++;
  for (std::uint32_t i = 0; i < n; ++i)
    if (number[set_of[i]] >= 0) {
      evidence.piece[i] = number[set_of[i]];
      evidence.length[i] = static_cast<float> (2.0 * half[set_of[i]] / spacing);
    }
}

template <typename T>
std::vector<T>
carried (const std::vector<T>& values, const std::vector<std::int32_t>& sample_of)
{
  std::vector<T> result (sample_of.size ());
  for (std::size_t i = 0; i < sample_of.size (); ++i)
    result[i] = values[sample_of[i]];
  return result;
}

} // namespace

LevelEvidence
evaluateLevel (const SampleDimensions& dimensions, const std::vector<std::int32_t>& sample_of, double spacing)
{
  LevelEvidence of_samples;
  Spread spread;
  if (dimensions.complex->affine_dimension < 2) {
    const auto n = static_cast<std::size_t> (dimensions.complex->samples->size ());
    const bool line = dimensions.complex->affine_dimension == 1;
    spread.direction = dimensions.tangents.cast<float> ();
    spread.flat.assign (n, 0);
    of_samples.pieces = line ? 1 : 0;
    of_samples.piece.assign (n, line ? 0 : -1);
    of_samples.length.assign (n, line ? static_cast<float> (n) : 0.0f);
  } else {
    spread = spreadOf (dimensions, spacing);
    joinPieces (dimensions.complex->samples->points, spread, spacing, of_samples);
  }
  LevelEvidence evidence;
  evidence.dimension = carried (dimensions.dimension, sample_of);
  evidence.manifold_dimension = carried (dimensions.manifold_dimension, sample_of);
  evidence.boundary = carried (dimensions.boundary, sample_of);
  evidence.confidence = carried (dimensions.confidence, sample_of);
  evidence.flat = carried (spread.flat, sample_of);
  evidence.length = carried (of_samples.length, sample_of);
  evidence.piece = carried (of_samples.piece, sample_of);
  evidence.pieces = of_samples.pieces;
  evidence.direction.resize (3, static_cast<Eigen::Index> (sample_of.size ()));
  for (std::size_t i = 0; i < sample_of.size (); ++i)
    evidence.direction.col (static_cast<Eigen::Index> (i)) = spread.direction.col (sample_of[i]);
  return evidence;
}

} // namespace manifold
} // namespace pcl
