#include <pcl/manifold/detail/guarded.h>

#include "fixed_point/restriction_dag.h"
#include "points/nearest_neighbors.h"

#include <algorithm>
#include <utility>

namespace pcl {
namespace manifold {

namespace {

FacetFlags
flagsOf (const DelaunayComplex& complex, const std::vector<Facet>& facets)
{
  FacetFlags flags = noFacets (complex);
  for (const Facet& facet : facets)
    setFacet (complex, facet, flags);
  return flags;
}

bool
areValid (const FlatPieces& pieces)
{
  return pieces.vertices.allFinite () &&
         std::all_of (pieces.triangles.begin (), pieces.triangles.end (), [&pieces] (const auto& triangle) {
           return std::all_of (triangle.begin (), triangle.end (), [&pieces] (std::int32_t vertex) {
             return vertex >= 0 && vertex < pieces.vertices.cols ();
           });
         });
}

// Samples from which it is not far to the nearest ones. Far away vertices are looked up at the nearest place
// in the box of the samples, so that squares do not overflow.
std::vector<std::int32_t>
startSamples (const Eigen::Matrix3Xd& points, const Eigen::Matrix3Xd& vertices)
{
  Eigen::Matrix3Xd queries = vertices;
  for (int axis = 0; axis < 3; ++axis)
    queries.row (axis) =
      queries.row (axis).cwiseMax (points.row (axis).minCoeff ()).cwiseMin (points.row (axis).maxCoeff ());
  return nearestPoints (points, queries);
}

FacetFlags
restricted (const DelaunayComplex& complex, const FlatPieces& pieces)
{
  if (complex.affine_dimension < 2 || pieces.triangles.empty ())
    return noFacets (complex);
  const std::vector<std::int32_t> starts = startSamples (complex.samples->points, pieces.vertices);
  const Children children = generateChildren (
    complex, pieces.triangles.size (), [&](PieceWalk & walk, std::size_t i) -> const auto& {
      const std::array<std::int32_t, 3>& triangle = pieces.triangles[i];
      const Piece piece{pieces.vertices.col (triangle[0]), pieces.vertices.col (triangle[1]),
                        pieces.vertices.col (triangle[2])};
      return walk.find (piece, starts[triangle[0]]);
    });
  return flagsOf (complex, children.facets);
}

} // namespace

Status
restrictedDelaunay (const DelaunayComplex& complex, const FlatPieces& pieces, FacetFlags& result) noexcept
{
  result.mask.clear ();
  return guarded ([&] {
    if (!areValid (pieces))
      return Status::PARAMETER_OUT_OF_RANGE;
    result = restricted (complex, pieces);
    return Status::OK;
  });
}

FacetFlags
restrictedDelaunay (const DelaunayComplex& complex, const FacetFlags& pieces)
{
  const std::vector<Facet> facets = facetsOf (complex, pieces);
  const Children children = generateChildren (
    complex, facets.size (), [&facets](PieceWalk & walk, std::size_t i) -> const auto& {
      return walk.find (facets[i]);
    });
  return flagsOf (complex, children.facets);
}

} // namespace manifold
} // namespace pcl
