// Faces that are cut because they are too long.
#include "oracle_landmark_mesh.h"

#include "graph/faces/long_faces.h"

#include <gtest/gtest.h>

namespace {

using namespace oracle;
using pcl::manifold::ContactRows;
using pcl::manifold::LongFaces;

// A cycle of n adjacent tiles, some of which touch others of it.
struct Ring
{
  Walk face;
  std::vector<TileContact> contacts;

  explicit Ring (int n)
  {
    for (index_t i = 0; i < n; ++i)
      face.push_back (i);
    for (index_t i = 0; i < n; ++i)
      touch (i, (i + 1) % n, 30, true);
  }

  void touch (index_t a, index_t b, int boundary_points, bool adjacent = false)
  {
    TileContact contact;
    contact.first = std::min (a, b);
    contact.second = std::max (a, b);
    contact.boundary_points = boundary_points;
    contact.adjacent = adjacent;
    contacts.push_back (contact);
    std::sort (contacts.begin (), contacts.end (), [] (const TileContact& p, const TileContact& q) {
      return std::pair (p.first, p.second) < std::pair (q.first, q.second);
    });
  }
};

struct Cut
{
  std::vector<Walk> faces;
  std::vector<Walk> holes;
  std::vector<LandmarkMesh::Edge> chords;
};

Cut
cut (const Ring& ring, std::size_t maximum_length)
{
  Cut result;
  const ContactRows rows (ring.face.size (), ring.contacts);
  LongFaces long_faces (rows, maximum_length);
  long_faces.cut (ring.face, result.faces, result.holes);
  result.chords = long_faces.chords ();
  return result;
}

TEST (LongFaces, AreLeftAloneIfShort)
{
  Ring ring (8);
  ring.touch (0, 4, 5);
  const Cut result = cut (ring, 8);
  EXPECT_EQ (result.faces, std::vector<Walk>{ring.face});
  EXPECT_TRUE (result.holes.empty ());
  EXPECT_TRUE (result.chords.empty ());
}

TEST (LongFaces, AreHolesIfNothingTouchesAcross)
{
  const Cut result = cut (Ring (9), 8);
  EXPECT_TRUE (result.faces.empty ());
  EXPECT_EQ (result.holes, std::vector<Walk>{Ring (9).face});
}

TEST (LongFaces, AreCutWhereTilesTouchMost)
{
  Ring ring (10);
  ring.touch (1, 6, 4);
  ring.touch (2, 5, 7);
  const Cut once = cut (ring, 8);
  EXPECT_EQ (once.chords, std::vector<LandmarkMesh::Edge> ({{2, 5}}));
  EXPECT_EQ (normalizedAll (once.faces), normalizedAll ({{2, 3, 4, 5}, {0, 1, 2, 5, 6, 7, 8, 9}}));
  EXPECT_TRUE (once.holes.empty ());

  const Cut twice = cut (ring, 6);
  EXPECT_EQ (normalizedAll (twice.faces), normalizedAll ({{2, 3, 4, 5}, {1, 2, 5, 6}, {0, 1, 6, 7, 8, 9}}));

  // What is left of it cannot be cut any more.
  const Cut rest = cut (ring, 5);
  EXPECT_EQ (normalizedAll (rest.faces), normalizedAll ({{2, 3, 4, 5}, {1, 2, 5, 6}}));
  EXPECT_EQ (normalizedAll (rest.holes), normalizedAll ({{0, 1, 6, 7, 8, 9}}));
}

// A contact is used once, also if tiles are passed twice.
TEST (LongFaces, MayPassTilesTwice)
{
  Ring ring (6);
  ring.touch (0, 3, 2);
  ring.face = {0, 1, 2, 3, 4, 5, 0, 1, 2, 3, 4, 5};
  const Cut result = cut (ring, 8);
  EXPECT_EQ (result.chords.size (), 1u);
  std::size_t sides = 0;
  for (const auto* walks : {&result.faces, &result.holes})
    for (const Walk& walk : *walks)
      sides += walk.size ();
  EXPECT_EQ (sides, ring.face.size () + 2);
}

TEST (LongFaces, AreHolesIfVeryLong)
{
  Ring ring (300);
  ring.touch (0, 150, 5);
  const Cut result = cut (ring, 200);
  EXPECT_TRUE (result.faces.empty ());
  EXPECT_EQ (result.holes.size (), 1u);
}

} // namespace
