// The restricted Delaunay operator against every triangle times every piece.
#include "oracle_fixed_point.h"

#include "common/parallel.h"
#include "fixed_point/facet_flags.h"
#include "fixed_point/piece_walk.h"

#include <pcl/manifold/fixed_point_complex.h>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

namespace {

using namespace oracle;
using pcl::manifold::DelaunayComplex;
using pcl::manifold::Facet;
using pcl::manifold::FacetFlags;
using pcl::manifold::facetsOf;
using pcl::manifold::FlatPieces;
using pcl::manifold::Piece;
using pcl::manifold::PieceWalk;
using pcl::manifold::restrictedDelaunay;
using pcl::manifold::Status;
using pcl::manifold::withThreads;
using Facets = std::vector<Facet>;

Eigen::Matrix3d
asColumns (const Piece& piece)
{
  Eigen::Matrix3d columns;
  columns << piece[0], piece[1], piece[2];
  return columns;
}

// Ascending; fails on duplicates.
Facets
sorted (Facets facets)
{
  std::sort (facets.begin (), facets.end ());
  EXPECT_TRUE (std::adjacent_find (facets.begin (), facets.end ()) == facets.end ());
  return facets;
}

void
expectPieces (const Eigen::Matrix3Xd& cloud, int pieces, std::uint64_t seed, std::size_t& found)
{
  const auto complex = complexOf (cloud);
  if (complex->affine_dimension < 2)
    return;
  const RestrictedOracle expected (*complex);
  PieceWalk walk (*complex);
  Random random (seed);
  for (int i = 0; i < pieces; ++i) {
    const Piece piece = latticePiece (cloud, random);
    const std::int32_t start = random.index (static_cast<int> (cloud.cols ()));
    const Facets result = sorted (walk.find (piece, start));
    found += result.size ();
    ASSERT_TRUE (result == expected.generatedBy (piece))
      << result.size () << " triangles from sample " << start << " of\n"
      << cloud << "\nfor the piece\n"
      << asColumns (piece);
  }
}

TEST (RestrictedDelaunay, OfSinglePieces)
{
  std::size_t found = 0;
  forEachLattice (110, 3, 14, [&found] (const Eigen::Matrix3Xd& lattice, int kind) {
    if (!testing::Test::HasFatalFailure ())
      expectPieces (2 * lattice, 30, static_cast<std::uint64_t> (kind), found);
  });
  EXPECT_GT (found, 50000u);
}

TEST (RestrictedDelaunay, OfSinglePiecesOfLargerClouds)
{
  std::size_t found = 0;
  forEachLattice (8, 30, 80, [&found] (const Eigen::Matrix3Xd& lattice, int kind) {
    if (!testing::Test::HasFatalFailure ())
      expectPieces (2 * lattice, 30, static_cast<std::uint64_t> (kind), found);
  });
  EXPECT_GT (found, 15000u);
}

// Every Delaunay triangle as a piece: what it generates.
void
expectChildren (const Eigen::Matrix3Xd& cloud, std::size_t& found)
{
  const auto complex = complexOf (cloud);
  if (complex->affine_dimension < 2)
    return;
  const RestrictedOracle expected (*complex);
  PieceWalk walk (*complex);
  for (const Facet& facet : expected.facets) {
    const Piece piece = trianglePoints (*complex, facet);
    const Facets result = sorted (walk.find (facet));
    found += result.size ();
    ASSERT_TRUE (result == expected.generatedBy (piece)) << result.size () << " triangles of\n"
                                                         << cloud << "\nfor\n"
                                                         << asColumns (piece);
  }
}

TEST (RestrictedDelaunay, OfSingleTriangles)
{
  std::size_t found = 0;
  forEachLattice (110, 3, 14, [&found] (const Eigen::Matrix3Xd& lattice, int) {
    if (!testing::Test::HasFatalFailure ())
      expectChildren (lattice, found);
  });
  forEachLattice (2, 20, 40, [&found] (const Eigen::Matrix3Xd& lattice, int) {
    if (!testing::Test::HasFatalFailure ())
      expectChildren (lattice, found);
  });
  EXPECT_GT (found, 50000u);
}

Facets
unionOf (const RestrictedOracle& expected, const std::vector<Piece>& pieces)
{
  std::set<Facet> all;
  for (const Piece& piece : pieces)
    for (const Facet& facet : expected.generatedBy (piece))
      all.insert (facet);
  return {all.begin (), all.end ()};
}

TEST (RestrictedDelaunay, OfMeshesAndOfSetsOfTriangles)
{
  forEachLattice (30, 1, 14, [] (const Eigen::Matrix3Xd& lattice, int kind) {
    const Eigen::Matrix3Xd cloud = 2 * lattice;
    const auto complex = complexOf (cloud);
    const RestrictedOracle expected (*complex);
    Random random (static_cast<std::uint64_t> (kind));

    FlatPieces mesh;
    std::vector<Piece> pieces;
    mesh.vertices.resize (3, 30);
    for (std::int32_t i = 0; i < 10; ++i) {
      pieces.push_back (latticePiece (cloud, random));
      mesh.triangles.push_back ({3 * i, 3 * i + 1, 3 * i + 2});
      for (int k = 0; k < 3; ++k)
        mesh.vertices.col (3 * i + k) = pieces.back ()[static_cast<std::size_t> (k)];
    }
    FacetFlags result;
    ASSERT_EQ (restrictedDelaunay (*complex, mesh, result), Status::OK);
    ASSERT_EQ (result.mask.size (), complex->cells.size ());
    ASSERT_TRUE (facetsOf (*complex, result) == unionOf (expected, pieces)) << kind;

    FacetFlags start = pcl::manifold::noFacets (*complex);
    pieces.clear ();
    for (const Facet& facet : expected.facets)
      if (random.index (4) == 0) {
        setFacet (*complex, facet, start);
        pieces.push_back (trianglePoints (*complex, facet));
      }
    ASSERT_TRUE (facetsOf (*complex, restrictedDelaunay (*complex, start)) == unionOf (expected, pieces))
      << kind;
  });
}

// Two triangles that together are a square, over samples in a plane.
TEST (RestrictedDelaunay, OfASquareOverASquare)
{
  Eigen::Matrix3Xd cloud (3, 4);
  cloud << 0, 2, 0, 2, 0, 0, 2, 2, 0, 0, 0, 0;
  const auto complex = complexOf (cloud);
  ASSERT_EQ (complex->affine_dimension, 2);
  FlatPieces mesh;
  mesh.vertices.resize (3, 3);
  mesh.vertices << 0, 3, 0, 0, 0, 3, 7, 7, 7;
  mesh.triangles = {{0, 1, 2}};
  FacetFlags result;
  ASSERT_EQ (restrictedDelaunay (*complex, mesh, result), Status::OK);
  EXPECT_EQ (facetsOf (*complex, result).size (), 2u) << "both have their circumcentre under it";
  mesh.vertices.row (0).array () += 1.5; // beside the centre
  ASSERT_EQ (restrictedDelaunay (*complex, mesh, result), Status::OK);
  EXPECT_EQ (facetsOf (*complex, result).size (), 0u);
  mesh.vertices.row (0).array () -= 0.5; // a corner or a side on it
  ASSERT_EQ (restrictedDelaunay (*complex, mesh, result), Status::OK);
  EXPECT_EQ (facetsOf (*complex, result).size (), 2u);
}

TEST (RestrictedDelaunay, OfTooFewSamplesIsEmpty)
{
  for (int samples = 0; samples <= 3; ++samples) {
    Eigen::Matrix3Xd cloud (3, samples);
    for (int i = 0; i < samples; ++i)
      cloud.col (i) = Eigen::Vector3d (i, 2 * i, -i);
    const auto complex = complexOf (cloud);
    FlatPieces mesh;
    mesh.vertices = 10 * Eigen::Matrix3Xd::Random (3, 3);
    mesh.triangles = {{0, 1, 2}};
    FacetFlags result;
    EXPECT_EQ (restrictedDelaunay (*complex, mesh, result), Status::OK);
    EXPECT_TRUE (result.mask.empty ());
    EXPECT_TRUE (restrictedDelaunay (*complex, result).mask.empty ());
  }
}

TEST (RestrictedDelaunay, OfNothingIsEmpty)
{
  const auto complex = complexOf (latticeCloud (Lattice::GENERIC, 20, 1));
  FacetFlags result;
  EXPECT_EQ (restrictedDelaunay (*complex, FlatPieces (), result), Status::OK);
  EXPECT_EQ (result.mask.size (), complex->cells.size ());
  EXPECT_TRUE (facetsOf (*complex, result).empty ());
  EXPECT_TRUE (restrictedDelaunay (*complex, result) == result);
}

TEST (RestrictedDelaunay, RefusesWhatIsNoMesh)
{
  const auto complex = complexOf (latticeCloud (Lattice::GENERIC, 20, 1));
  FlatPieces mesh;
  mesh.vertices = 1e5 * Eigen::Matrix3Xd::Random (3, 4);
  mesh.triangles = {{0, 1, 2}, {1, 2, 3}};
  FacetFlags result;
  ASSERT_EQ (restrictedDelaunay (*complex, mesh, result), Status::OK);
  const auto expectRefused = [&] (const FlatPieces& bad) {
    EXPECT_EQ (restrictedDelaunay (*complex, bad, result), Status::PARAMETER_OUT_OF_RANGE);
    EXPECT_TRUE (result.mask.empty ());
  };
  for (const double x : {std::numeric_limits<double>::quiet_NaN (), std::numeric_limits<double>::infinity (),
                         -std::numeric_limits<double>::infinity ()}) {
    FlatPieces bad = mesh;
    bad.vertices (1, 3) = x;
    expectRefused (bad);
  }
  for (const std::int32_t vertex : {-1, 4, INT32_MIN, INT32_MAX}) {
    FlatPieces bad = mesh;
    bad.triangles[1][2] = vertex;
    expectRefused (bad);
  }
}

// Far beyond where squares are finite, and where differences to the samples are all the same.
TEST (RestrictedDelaunay, OfPiecesOfAnySize)
{
  const auto complex = complexOf (latticeCloud (Lattice::CROWDED, 30, 2));
  const RestrictedOracle expected (*complex);
  for (const double size : {1e-300, 1e-20, 1e10, 1e100, 1e300}) {
    FlatPieces mesh;
    mesh.vertices.resize (3, 3);
    mesh.vertices << size, -size, 0, size, 0, -size, 0, 0, 0;
    mesh.triangles = {{0, 1, 2}};
    FacetFlags result;
    ASSERT_EQ (restrictedDelaunay (*complex, mesh, result), Status::OK);
    Facets all;
    for (const Facet& facet : expected.facets) {
      VoronoiEdge<Rational> edge (trianglePoints (*complex, facet));
      for (Eigen::Index v = 0; v < complex->samples->points.cols (); ++v)
        edge.cut (complex->samples->points.col (v));
      if (edge.meets ({mesh.vertices.col (0), mesh.vertices.col (1), mesh.vertices.col (2)}))
        all.push_back (facet);
    }
    EXPECT_TRUE (facetsOf (*complex, result) == all) << size;
  }
}

TEST (RestrictedDelaunay, DoesNotDependOnThreads)
{
  const Eigen::Matrix3Xd cloud = latticeCloud (Lattice::SPHERE, 3000, 5);
  const auto complex = complexOf (cloud);
  Random random (7);
  FlatPieces mesh;
  mesh.vertices.resize (3, 6000);
  for (std::int32_t i = 0; i < 2000; ++i) {
    const Eigen::Vector3d center = cloud.col (random.index (3000));
    for (int k = 0; k < 3; ++k)
      mesh.vertices.col (3 * i + k) =
        center +
        15000 * Eigen::Vector3d (random.uniform (-1, 1), random.uniform (-1, 1), random.uniform (-1, 1));
    mesh.triangles.push_back ({3 * i, 3 * i + 1, 3 * i + 2});
  }
  FacetFlags one;
  FacetFlags two;
  withThreads (1, [&] { ASSERT_EQ (restrictedDelaunay (*complex, mesh, one), Status::OK); });
  withThreads (2, [&] { ASSERT_EQ (restrictedDelaunay (*complex, mesh, two), Status::OK); });
  EXPECT_TRUE (one == two);
  EXPECT_GT (facetsOf (*complex, one).size (), 2000u);
  FacetFlags next_one;
  FacetFlags next_two;
  withThreads (1, [&] { next_one = restrictedDelaunay (*complex, one); });
  withThreads (2, [&] { next_two = restrictedDelaunay (*complex, one); });
  EXPECT_TRUE (next_one == next_two);
}

} // namespace
