// What a Voronoi cell visits, against a look at all Delaunay cells.
#include "oracle_lattice.h"

#include "voronoi/voronoi_cell.h"

#include <gtest/gtest.h>

#include <set>

namespace {

using namespace oracle;
using pcl::manifold::DelaunayComplex;
using pcl::manifold::VoronoiCell;

constexpr std::int32_t INFINITE = DelaunayComplex::INFINITE_VERTEX;
using Simplex = std::set<std::int32_t>;

struct Visited
{
  std::multiset<Simplex> facets;              ///< dual to edges
  std::multiset<std::int32_t> hull_neighbors; ///< dual to unbounded faces
  Simplex neighbors;
};

Visited
lookAtAll (const DelaunayComplex& complex, std::int32_t p)
{
  std::set<Simplex> facets;
  Visited result;
  Simplex hull_neighbors;
  for (const DelaunayComplex::Cell& vertices : complex.cells) {
    const Simplex cell (vertices.begin (), vertices.end ());
    if (cell.count (p) == 0)
      continue;
    for (const std::int32_t q : cell) {
      if (q != p && q != INFINITE) {
        result.neighbors.insert (q);
        if (cell.count (INFINITE) != 0)
          hull_neighbors.insert (q);
      }
      Simplex facet = cell;
      facet.erase (q);
      if (q != p && facet.count (INFINITE) == 0)
        facets.insert (facet);
    }
  }
  result.facets.insert (facets.begin (), facets.end ());
  result.hull_neighbors.insert (hull_neighbors.begin (), hull_neighbors.end ());
  return result;
}

Visited
visitAll (const DelaunayComplex& complex, std::int32_t p)
{
  Visited result;
  const VoronoiCell cell (complex, p);
  cell.forEachEdge ([&] (std::int32_t a, std::int32_t b, int facet) {
    EXPECT_LT (a, b);
    const DelaunayComplex::Cell& vertices = complex.cells[static_cast<std::size_t> (a)];
    Simplex others (vertices.begin (), vertices.end ());
    others.erase (vertices[static_cast<std::size_t> (facet)]);
    result.facets.insert (others);
  });
  cell.forEachUnboundedFace ([&] (std::int32_t a, std::int32_t b, std::int32_t q, std::int32_t r) {
    const DelaunayComplex::Cell& vertices = complex.cells[static_cast<std::size_t> (a)];
    EXPECT_TRUE (complex.isInfinite (a) && complex.isInfinite (b));
    EXPECT_EQ (Simplex (vertices.begin (), vertices.end ()), (Simplex{p, q, r, INFINITE}));
    result.hull_neighbors.insert (q);
  });
  cell.forEachNeighbor ([&] (std::int32_t q) { result.neighbors.insert (q); });
  return result;
}

TEST (VoronoiCell, VisitsEverythingOnce)
{
  forEachLattice (20, 3, 30, [] (const Eigen::Matrix3Xd& cloud, int kind) {
    const auto complex = complexOf (cloud);
    if (complex->affine_dimension < 2)
      return;
    for (std::int32_t p = 0; p < cloud.cols (); ++p) {
      const Visited expected = lookAtAll (*complex, p);
      Visited visited = visitAll (*complex, p);
      if (complex->affine_dimension == 2) { // both sides of the plane
        const Simplex once (visited.hull_neighbors.begin (), visited.hull_neighbors.end ());
        visited.hull_neighbors = {once.begin (), once.end ()};
      }
      ASSERT_EQ (visited.facets, expected.facets) << kind;
      ASSERT_EQ (visited.hull_neighbors, expected.hull_neighbors) << kind;
      ASSERT_EQ (visited.neighbors, expected.neighbors) << kind;
    }
  });
}

TEST (VoronoiCell, GivesVerticesRelativeToItsSample)
{
  Eigen::Matrix3Xd cloud (3, 4);
  cloud << 1, 5, 1, 1, 1, 1, 5, 1, 1, 1, 1, 5;
  const auto complex = complexOf (cloud);
  const VoronoiCell cell (*complex, 0);
  EXPECT_EQ (cell.end () - cell.begin (), 4);
  EXPECT_TRUE (cell.vertex (0) == Eigen::Vector3d (2, 2, 2));
  EXPECT_TRUE (cell.relative (1) == Eigen::Vector3d (4, 0, 0));
  EXPECT_FALSE (cell.isInfinite (0));
  for (std::int32_t infinite = 1; infinite < 5; ++infinite) {
    EXPECT_TRUE (cell.isInfinite (infinite));
    EXPECT_NEAR (cell.vertex (infinite).norm (), 1.0, 1e-15);
  }
}

} // namespace
