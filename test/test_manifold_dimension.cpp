// Which manifold a sample belongs to, and whether it is on its boundary, on shapes whose truth is known.
#include "common/parallel.h"
#include "voronoi/dimension.h"

#include <generate/catalogue.h>
#include <generate/sampling.h>

#include <gtest/gtest.h>

namespace {

using pcl::manifold::SampleDimensions;

struct Detected
{
  generate::LabelledCloud truth;
  SampleDimensions dimensions;
};

Detected
detect (const std::string& shape, std::size_t count, std::uint64_t seed)
{
  const generate::Shape known = generate::shapeByName (shape);
  Detected result;
  result.truth = generate::blueNoise (known, generate::spacingFor (known, count), seed);
  Eigen::Matrix3Xd cloud (3, static_cast<Eigen::Index> (result.truth.size ()));
  for (std::size_t i = 0; i < result.truth.size (); ++i)
    cloud.col (static_cast<Eigen::Index> (i)) = result.truth.points[i];
  auto samples = std::make_shared<pcl::manifold::SampleSet> ();
  EXPECT_EQ (pcl::manifold::makeSampleSet (cloud, {}, {}, 0x1p-53, *samples), pcl::manifold::Status::OK);
  result.dimensions =
    pcl::manifold::computeDimensions (pcl::manifold::computeDelaunayComplex (samples, 1), 0.3);
  pcl::manifold::decideManifoldDimensions (result.dimensions);
  return result;
}

// The shares of the points on the boundary and of the others with the right manifold dimension, and with the
// right boundary flag.
struct Shares
{
  double dimension[2];
  double boundary[2];
};

Shares
sharesOf (const Detected& detected)
{
  std::array<double, 2> count{};
  Shares shares{{0, 0}, {0, 0}};
  for (std::size_t i = 0; i < detected.truth.size (); ++i) {
    const auto sample = static_cast<std::size_t> (detected.dimensions.complex->samples->sample_of[i]);
    const std::size_t on_boundary = detected.truth.boundary[i];
    ++count[on_boundary];
    shares.dimension[on_boundary] +=
      detected.dimensions.manifold_dimension[sample] == detected.truth.labels[i];
    shares.boundary[on_boundary] += detected.dimensions.boundary[sample] == on_boundary;
  }
  for (std::size_t b = 0; b < 2; ++b) {
    shares.dimension[b] = count[b] > 0 ? shares.dimension[b] / count[b] : 1.0;
    shares.boundary[b] = count[b] > 0 ? shares.boundary[b] / count[b] : 1.0;
  }
  return shares;
}

void
expectShares (const std::string& shape, std::size_t count, double dimension, double boundary)
{
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const Shares shares = sharesOf (detect (shape, count, seed));
    for (const std::size_t on_boundary : {0, 1}) {
      EXPECT_GE (shares.dimension[on_boundary], dimension)
        << shape << ", seed " << seed << ", " << on_boundary;
      EXPECT_GE (shares.boundary[on_boundary], boundary) << shape << ", seed " << seed << ", " << on_boundary;
    }
  }
}

TEST (ManifoldDimension, OfCurves)
{
  for (const char* shape : {"circle", "trefoil", "segment", "helix"})
    expectShares (shape, 200, 1.0, 1.0);
}

TEST (ManifoldDimension, OfSurfacesWithoutRim)
{
  for (const char* shape : {"sphere", "torus"})
    expectShares (shape, 1500, 1.0, 1.0);
}

TEST (ManifoldDimension, OfSurfacesWithRims)
{
  for (const char* shape : {"hemisphere", "annulus", "moebius", "cylinder"})
    expectShares (shape, 1500, 1.0, 0.99);
  for (const char* shape : {"square", "terrain"}) // these have corners
    expectShares (shape, 1500, 0.95, 0.95);
}

TEST (ManifoldDimension, OfSolidsAndTheirSkins)
{
  for (const char* shape : {"ball", "solid-torus"})
    expectShares (shape, 2500, 0.98, 0.98);
  expectShares ("box", 2500, 0.8, 0.8); // at its edges the labels are those of curves
}

} // namespace
