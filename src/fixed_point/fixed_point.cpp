#include "fixed_point/restriction_dag.h"

namespace pcl {
namespace manifold {

namespace {

// The children of every node as numbers of nodes.
std::vector<std::size_t>
childNumbers (const DelaunayComplex& complex, const RestrictionDag& dag)
{
  const auto key = [] (const Facet& facet) {
    return 4 * static_cast<std::size_t> (facet.cell) + static_cast<std::size_t> (facet.facet);
  };
  std::vector<std::uint32_t> number (4 * complex.cells.size ());
  for (std::size_t i = 0; i < dag.nodes.size (); ++i)
    number[key (dag.nodes[i])] = static_cast<std::uint32_t> (i);
  std::vector<std::size_t> numbers;
  numbers.reserve (dag.children.facets.size ());
  for (const Facet& child : dag.children.facets)
    numbers.push_back (number[key (child)]);
  return numbers;
}

} // namespace

FixedPoint
fixedPoint (const DelaunayComplex& complex, const FacetFlags& start)
{
  const std::vector<Facet> facets = facetsOf (complex, start);
  const RestrictionDag dag = restrictionDag (complex, facets);
  const std::vector<std::size_t> child = childNumbers (complex, dag);
  // The triangles of the start are the first nodes.
  std::vector<std::uint8_t> current (dag.nodes.size (), 0);
  std::fill_n (current.begin (), facets.size (), std::uint8_t (1));
  FixedPoint result;
  for (std::vector<std::uint8_t> next;; ++result.iterations, current.swap (next)) {
    next.assign (current.size (), 0);
    for (std::size_t i = 0; i < current.size (); ++i)
      for (std::size_t k = dag.children.offsets[i]; current[i] != 0 && k < dag.children.offsets[i + 1]; ++k)
        next[child[k]] = 1;
    if (next == current)
      break;
  }
  result.facets = noFacets (complex);
  for (std::size_t i = 0; i < current.size (); ++i)
    if (current[i] != 0)
      setFacet (complex, dag.nodes[i], result.facets);
  return result;
}

} // namespace manifold
} // namespace pcl
