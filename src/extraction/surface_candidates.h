#pragma once

#include <pcl/manifold/fixed_point_complex.h>

#include "extraction/sample_roles.h"

#include <cstdint>
#include <vector>

namespace pcl {
namespace manifold {

/** Which Delaunay triangles may be part of a surface: those that the cocones of their samples choose, or a
 * set that another method found. */
class SurfaceCandidates
{
public:
  /** \param[in] facets the set of another method; null for the candidates of COCONESHAPE, triangles whose
   * dual Voronoi edge meets the cocone of one of their surface samples. All three must outlive this object.
   */
  SurfaceCandidates (const SampleDimensions& dimensions, const std::vector<Role>& roles,
                     const FacetFlags* facets = nullptr)
    : dimensions_ (dimensions), roles_ (roles), facets_ (facets)
  {}

  /** Whether a triangle, given as a facet of a cell, is one. One with an infinite vertex never is. */
  bool contains (std::int32_t cell, int facet) const;

  /** Whether those at a sample across which the colour changes form one disk or half-disk that has the cells
   * of one colour on one side and those of the other colour on the other. */
  bool areManifoldAt (std::int32_t sample, const std::vector<std::uint8_t>& colors) const;

  const SampleDimensions& dimensions () const { return dimensions_; }

  const std::vector<Role>& roles () const { return roles_; }

  const DelaunayComplex& complex () const { return *dimensions_.complex; }

private:
  const SampleDimensions& dimensions_;
  const std::vector<Role>& roles_;
  const FacetFlags* facets_;
};

} // namespace manifold
} // namespace pcl
