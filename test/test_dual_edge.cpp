// Whether pieces meet Voronoi edges, against numbers without rounding.
#include "oracle_fixed_point.h"
#include "oracle_nudged.h"

#include "fixed_point/facet_duals.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace oracle;
using Eigen::Vector3d;
using pcl::manifold::DualEdge;
using pcl::manifold::dualEdge;
using pcl::manifold::meets;
using pcl::manifold::Piece;

// How often each answer was given.
struct Answers
{
  int no = 0;
  int yes = 0;
};

void
expectMeets (const Piece& piece, const DualEdge& edge, Answers& answers)
{
  VoronoiEdge<Rational> expected (edge.triangle);
  for (int i = 0; i < edge.bounds; ++i)
    expected.cut (edge.opposite[i]);
  if (expected.empty ())
    return; // not locally Delaunay: no Voronoi edge
  const bool result = meets (piece, edge);
  ++(result ? answers.yes : answers.no);
  ASSERT_EQ (result, expected.meets (piece))
    << "edge\n"
    << edge.triangle[0].transpose () << "\n"
    << edge.triangle[1].transpose () << "\n"
    << edge.triangle[2].transpose () << "\nbounds " << edge.bounds << "\n"
    << edge.opposite[0].transpose () << "\n"
    << edge.opposite[1].transpose () << "\npiece\n"
    << piece[0].transpose () << "\n"
    << piece[1].transpose () << "\n"
    << piece[2].transpose ();
}

Vector3d
centerOfTriangle (const DualEdge& edge)
{
  const Vector3d u = edge.triangle[1] - edge.triangle[0];
  const Vector3d v = edge.triangle[2] - edge.triangle[0];
  const Vector3d n = u.cross (v);
  return edge.triangle[0] +
         (u.squaredNorm () * v.cross (n) + v.squaredNorm () * n.cross (u)) / (2 * n.squaredNorm ());
}

DualEdge
anyEdge (Random& random)
{
  DualEdge edge{{anyPoint (random), anyPoint (random), anyPoint (random)}, {}, random.index (3)};
  const Vector3d normal = (edge.triangle[1] - edge.triangle[0]).cross (edge.triangle[2] - edge.triangle[0]);
  edge.opposite = {anyPoint (random), anyPoint (random)};
  // One on either side of the triangle.
  for (std::size_t i = 0; i < 2; ++i) {
    const double height = (edge.opposite[i] - edge.triangle[0]).dot (normal);
    if ((height > 0) == (i == 1))
      edge.opposite[i] -= 2 * height / normal.squaredNorm () * normal;
  }
  return edge;
}

// All corners at random.
TEST (Meets, AnyPieces)
{
  Answers answers;
  for (std::uint64_t round = 0; round < 6000; ++round) {
    Random random (round);
    const DualEdge edge = anyEdge (random);
    expectMeets ({2 * anyPoint (random), 2 * anyPoint (random), 2 * anyPoint (random)}, edge, answers);
  }
  EXPECT_GT (answers.yes, 100);
  EXPECT_GT (answers.no, 1000);
}

// A piece that has the circumcentre, or another point of the line, rounded, at a corner, on a side or inside,
// or that is parallel to the edge: all that doubles can tell is rounding.
TEST (Meets, PiecesThatTouch)
{
  Answers answers;
  for (std::uint64_t round = 0; round < 6000; ++round) {
    Random random (round);
    const DualEdge edge = anyEdge (random);
    const Vector3d normal = (edge.triangle[1] - edge.triangle[0]).cross (edge.triangle[2] - edge.triangle[0]);
    const Vector3d center = centerOfTriangle (edge);
    const auto onLine = [&] { return Vector3d (center + random.uniform (-1, 1) * normal); };
    const Vector3d x = onLine ();
    const Vector3d d = anyPoint (random);
    Piece piece{x, anyPoint (random), anyPoint (random)};
    switch (random.index (5)) {
      case 0:
        break;
      case 1:
        piece = {x + d, x - d, anyPoint (random)};
        break;
      case 2:
        piece = {x, onLine (), anyPoint (random)};
        break;
      case 3:
        piece = {x + d, x - d, onLine ()};
        break;
      default:
        piece = {x + d, x - d, x - 0.5 * d};
    }
    for (Vector3d& corner : piece)
      corner = nudged (corner, random);
    expectMeets (piece, edge, answers);
  }
  EXPECT_GT (answers.yes, 1000);
  EXPECT_GT (answers.no, 1000);
}

// The rounded ends of the edge are corners of the piece, or samples are nearly cospherical.
TEST (Meets, PiecesAtTheEndsOfTheEdge)
{
  Answers answers;
  for (std::uint64_t round = 0; round < 6000; ++round) {
    Random random (round);
    DualEdge edge = anyEdge (random);
    edge.bounds = 2;
    const Vector3d center = anyPoint (random);
    const auto onSphere = [&] { return Vector3d (center + anyPoint (random).normalized ()); };
    edge.triangle = {onSphere (), onSphere (), onSphere ()};
    edge.opposite[0] = onSphere ();
    if (random.coin ())
      edge.opposite[1] = onSphere ();
    const Vector3d d = anyPoint (random);
    const Piece piece{nudged (center + d, random), nudged (center - d, random),
                      random.coin () ? nudged (center, random) : anyPoint (random)};
    expectMeets (piece, edge, answers);
  }
  EXPECT_GT (answers.yes, 100);
  EXPECT_GT (answers.no, 1000);
}

// What doubles cannot hold any more: products overflow or underflow, or differences are lost.
TEST (Meets, PiecesOfEverySize)
{
  Answers answers;
  for (std::uint64_t round = 0; round < 3000; ++round) {
    Random random (round);
    DualEdge edge = anyEdge (random);
    const Vector3d center = centerOfTriangle (edge);
    const Vector3d d = anyPoint (random);
    Piece piece{center + d, center - d, anyPoint (random)};
    const double size = std::ldexp (1.0, random.integer (-1060, 1000));
    const bool all = random.coin ();
    for (Vector3d& corner : piece)
      corner *= size;
    if (all) {
      for (Vector3d& corner : edge.triangle)
        corner *= size;
      for (Vector3d& sample : edge.opposite)
        sample *= size;
      const Vector3d u = edge.triangle[1] - edge.triangle[0];
      // Rounding can make the tiniest ones collinear or flat.
      if (isZero (cross (exact<Rational> (u), fromTo<Rational> (edge.triangle[0], edge.triangle[2]))))
        continue;
    }
    expectMeets (piece, edge, answers);
  }
  EXPECT_GT (answers.yes, 200);
  EXPECT_GT (answers.no, 500);
}

// Small integers times any power of two, where ties are common: up to where degree six no longer fits into 64
// bits; and some that are off the lattice by less than what rounding to a difference shows.
TEST (Meets, PiecesOfIntegers)
{
  Answers answers;
  for (std::uint64_t round = 0; round < 12000; ++round) {
    Random random (round);
    const int size = 1 << random.index (21);
    const double unit = std::ldexp (1.0, random.integer (-60, 60));
    const double off = round % 3 == 0 ? 0x1p-90 : 0.0;
    const auto anyInteger = [&] { return static_cast<double> (random.integer (-size, size)); };
    const auto anyCorner = [&] {
      Vector3d corner (anyInteger (), anyInteger (), anyInteger ());
      if (random.index (3) == 0)
        corner[random.index (3)] = 0.0;
      for (int axis = 0; axis < 3; ++axis)
        if (corner[axis] == 0.0 && random.coin ())
          corner[axis] = random.coin () ? off : -off;
      return Vector3d (unit * corner);
    };
    DualEdge edge{{anyCorner (), anyCorner (), anyCorner ()}, {}, 0};
    if (isZero (cross (fromTo<Rational> (edge.triangle[0], edge.triangle[1]),
                       fromTo<Rational> (edge.triangle[0], edge.triangle[2]))))
      continue;
    edge.bounds = random.index (3);
    edge.opposite = {anyCorner (), anyCorner ()};
    bool flat = false;
    for (int i = 0; i < edge.bounds; ++i)
      flat = flat || orientation<Rational> (edge.triangle[0], edge.triangle[1], edge.triangle[2],
                                            edge.opposite[i]) == 0;
    if (flat)
      continue;
    // Through the triangle itself or a point of its line more often than not.
    Piece piece{anyCorner (), anyCorner (), anyCorner ()};
    if (random.coin ())
      piece[0] = edge.triangle[0];
    if (random.coin ())
      piece[1] = edge.triangle[1];
    if (random.coin ())
      piece[2] = 2 * centerOfTriangle (edge) - piece[1];
    expectMeets (piece, edge, answers);
  }
  EXPECT_GT (answers.yes, 500);
  EXPECT_GT (answers.no, 2000);
}

// Whatever is degenerate: on lattices everything is, sooner or later. The Voronoi edge is that of all
// samples.
TEST (Meets, PiecesOnLattices)
{
  Answers answers;
  forEachLattice (100, 3, 14, [&answers] (const Eigen::Matrix3Xd& lattice, int kind) {
    const Eigen::Matrix3Xd cloud = 2 * lattice;
    const auto complex = complexOf (cloud);
    const RestrictedOracle expected (*complex);
    Random random (static_cast<std::uint64_t> (kind + cloud.cols ()));
    for (std::size_t i = 0; i < expected.facets.size (); ++i) {
      const DualEdge edge = dualEdge (*complex, expected.facets[i]);
      for (int k = 0; k < 20; ++k) {
        const Piece piece = latticePiece (cloud, random);
        const bool result = meets (piece, edge);
        ++(result ? answers.yes : answers.no);
        ASSERT_EQ (result, expected.edges[i].meets (piece)) << "kind " << kind;
      }
    }
  });
  EXPECT_GT (answers.yes, 10000);
  EXPECT_GT (answers.no, 100000);
}

} // namespace
