#include "fixed_point/restriction_dag.h"

namespace pcl {
namespace manifold {

void
Children::append (const Children& other)
{
  const std::size_t before = facets.size ();
  for (std::size_t i = 1; i < other.offsets.size (); ++i)
    offsets.push_back (before + other.offsets[i]);
  facets.insert (facets.end (), other.facets.begin (), other.facets.end ());
}

RestrictionDag
restrictionDag (const DelaunayComplex& complex, const std::vector<Facet>& start)
{
  RestrictionDag dag;
  dag.reached = noFacets (complex);
  for (const Facet& facet : start)
    setFacet (complex, facet, dag.reached);
  std::vector<Facet> frontier = start;
  while (!frontier.empty ()) {
    dag.nodes.insert (dag.nodes.end (), frontier.begin (), frontier.end ());
    const Children children = generateChildren (
      complex, frontier.size (), [&frontier](PieceWalk & walk, std::size_t i) -> const auto& {
        return walk.find (frontier[i]);
      });
    frontier.clear ();
    for (const Facet& child : children.facets)
      if (setFacet (complex, child, dag.reached))
        frontier.push_back (child);
    std::sort (frontier.begin (), frontier.end ());
    dag.children.append (children);
  }
  return dag;
}

} // namespace manifold
} // namespace pcl
