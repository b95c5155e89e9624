#include <pcl/manifold/detail/guarded.h>

#include "fixed_point/anchored.h"
#include "fixed_point/critical_points.h"
#include "fixed_point/restriction_dag.h"

namespace pcl {
namespace manifold {

namespace {

Status
compute (const DelaunayComplex& complex, const CriticalPointParameters& parameters, StageLog& log,
         FixedPointComplex& result)
{
  if (!(parameters.ratio > 0.0) || parameters.votes < 1 || parameters.votes > 3)
    return Status::PARAMETER_OUT_OF_RANGE;
  result.manifold = noFacets (complex);
  result.medial = noFacets (complex);

  if (!log.begin ("anchored triangles", 0.6f))
    return Status::CANCELLED;
  const std::vector<Facet> anchored = anchoredTriangles (complex);

  if (!log.begin ("critical points", 0.62f))
    return Status::CANCELLED;
  const std::vector<std::uint8_t> medial = findMedial (complex, anchored, parameters);
  std::vector<Facet> manifold;
  for (std::size_t i = 0; i < anchored.size (); ++i) {
    setFacet (complex, anchored[i], medial[i] != 0 ? result.medial : result.manifold);
    if (medial[i] == 0)
      manifold.push_back (anchored[i]);
  }

  if (!log.begin ("chained triangles", 0.64f))
    return Status::CANCELLED;
  RestrictionDag dag = restrictionDag (complex, manifold);
  result.facets = std::move (dag.reached);
  result.anchored = anchored.size ();
  result.medial_anchored = anchored.size () - manifold.size ();
  result.chained = dag.nodes.size () - manifold.size ();
  return log.begin ("", 0.7f) ? Status::OK : Status::CANCELLED;
}

} // namespace

Status
computeFixedPointComplex (const DelaunayComplex& complex, const CriticalPointParameters& parameters,
                          StageLog& log, FixedPointComplex& result) noexcept
{
  result = {};
  const Status status = guarded ([&] { return compute (complex, parameters, log, result); });
  if (status != Status::OK)
    result = {};
  return status;
}

} // namespace manifold
} // namespace pcl
