#include "fixed_point/anchored.h"

#include "common/parallel.h"
#include "fixed_point/facet_duals.h"
#include "fixed_point/facet_flags.h"

#include <algorithm>

namespace pcl {
namespace manifold {

namespace {

bool
isFinite (const DelaunayComplex& complex, const Facet& facet)
{
  const std::array<std::int32_t, 3> samples = facetOf (complex, facet.cell, facet.facet);
  return std::find (samples.begin (), samples.end (), DelaunayComplex::INFINITE_VERTEX) == samples.end ();
}

// Whether a triangle is known not to have its circumcentre in it, which is most often the reason.
bool
isObtuse (const Piece& triangle)
{
  // Most are so by far: plain doubles tell, whose rounding is less than this share of the squares by far.
  constexpr double MARGIN = 1e-10;
  const Eigen::Vector3d sides[3] = {triangle[1] - triangle[0], triangle[2] - triangle[1],
                                    triangle[0] - triangle[2]};
  const double squares = sides[0].squaredNorm () + sides[1].squaredNorm () + sides[2].squaredNorm ();
  for (int i = 0; i < 3; ++i)
    if (sides[i].dot (sides[(i + 1) % 3]) > MARGIN * squares)
      return true;
  const NumberVector<FilteredNumber> ab = difference<FilteredNumber> (triangle[1], triangle[0]);
  const NumberVector<FilteredNumber> bc = difference<FilteredNumber> (triangle[2], triangle[1]);
  const NumberVector<FilteredNumber> ca = difference<FilteredNumber> (triangle[0], triangle[2]);
  return signOf (dot (ab, bc)) > 0 || signOf (dot (bc, ca)) > 0 || signOf (dot (ca, ab)) > 0;
}

bool
isAnchored (const DelaunayComplex& complex, const Facet& facet)
{
  if (!isFinite (complex, facet))
    return false;
  const Piece triangle = cornersOf (complex, facet);
  return !isObtuse (triangle) && meets (triangle, dualEdge (complex, facet));
}

} // namespace

std::vector<Facet>
anchoredTriangles (const DelaunayComplex& complex)
{
  FacetFlags flags = noFacets (complex); // of the cells with the smaller numbers only
  parallelFor (complex.cells.size (), [&] (std::size_t i) {
    const auto cell = static_cast<std::int32_t> (i);
    for (int k = 0; k < 4; ++k)
      if (cell < complex.neighbors[i][k] && isAnchored (complex, {cell, k}))
        flags.mask[i] |= static_cast<std::uint8_t> (1 << k);
  });
  return facetsOf (complex, flags);
}

} // namespace manifold
} // namespace pcl
