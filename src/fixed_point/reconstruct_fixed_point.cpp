#include <pcl/manifold/detail/guarded.h>
#include <pcl/manifold/reconstruct_fixed_point.h>

#include "common/parallel.h"
#include "delaunay/sampled_complex.h"
#include "extraction/extract_shape.h"
#include "extraction/facet_set.h"
#include "extraction/fan.h"
#include "extraction/to_input.h"
#include "fixed_point/facet_flags.h"
#include "voronoi/dimension.h"
#include "voronoi/voronoi_cell.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace pcl {
namespace manifold {

namespace {

// That of DimensionDetection. It only tells the rims of open surfaces from their inside.
constexpr double RHO = 0.3;

// From the coordinates of the cloud to those of the samples.
FlatPieces
inSampleSpace (const FlatPieces& mesh, const SampleSet& samples)
{
  FlatPieces result = mesh;
  result.vertices = (mesh.vertices.colwise () - samples.origin) * samples.scale;
  return result;
}

// The triangles of a set over the samples.
SimplicialComplex
trianglesOf (const DelaunayComplex& complex, const FacetFlags& flags)
{
  SimplicialComplex shape;
  for (const Facet& facet : facetsOf (complex, flags)) {
    const std::array<std::int32_t, 3> triangle = facetOf (complex, facet.cell, facet.facet);
    shape.triangles.push_back ({triangle[0], triangle[1], triangle[2]});
  }
  return shape;
}

// Where an initial mesh leads to: one application of the operator brings it among Delaunay triangles.
Status
iterateFrom (const FlatPieces& mesh, StageLog& log, FixedPointResult& result, SimplicialComplex& shape)
{
  const DelaunayComplex& complex = *result.complex;
  if (!log.begin ("fixed point", 0.6f))
    return Status::CANCELLED;
  FacetFlags start;
  const Status status = restrictedDelaunay (complex, inSampleSpace (mesh, *complex.samples), start);
  if (status != Status::OK)
    return status;
  FixedPoint fixed = fixedPoint (complex, start);
  result.iterations = fixed.iterations + 1;
  result.found.facets = std::move (fixed.facets);
  if (!log.begin ("orientation", 0.96f))
    return Status::CANCELLED;
  shape = trianglesOf (complex, result.found.facets);
  orientTriangles (shape.triangles, complex.samples->points);
  return Status::OK;
}

// Where samples are much nearer to each other in one direction than in the other, as those of line scanners,
// they look like samples of curves. Those that triangles of the complex go around are none of a rim.
void
keepInside (const DelaunayComplex& complex, const FacetFlags& facets, SampleDimensions& dimensions)
{
  parallelFor (dimensions.dimension.size (), [&] (std::size_t i) {
    if (dimensions.dimension[i] == 2)
      return;
    const auto sample = static_cast<std::int32_t> (i);
    Fan fan;
    std::vector<std::int32_t> link;
    VoronoiCell (complex, sample).forEachEdge ([&] (std::int32_t cell, std::int32_t, int facet) {
      if (!facets.contains (cell, facet))
        return;
      const std::array<std::int32_t, 2> side = oppositeSide (complex, cell, facet, sample);
      fan.add (side[0], side[1]);
      link.insert (link.end (), side.begin (), side.end ());
    });
    if (!link.empty () && std::all_of (link.begin (), link.end (),
                                       [&fan] (std::int32_t vertex) { return fan.degree (vertex) > 1; }))
      dimensions.dimension[i] = 2;
  });
}

// What the theory needs, section 7: for samples as dense as it asks for, the complex has a surface in it
// then.
bool
areProved (const CriticalPointParameters& critical)
{
  const CriticalPointParameters published;
  return critical.ratio <= published.ratio && critical.votes == published.votes;
}

// The manifold in the manifold fixed-point complex: by the extraction of COCONESHAPE, for which every sample
// is one of a surface.
Status
extractFrom (const FixedPointParameters& parameters, StageLog& log, FixedPointResult& result,
             SimplicialComplex& shape)
{
  const Status status = computeFixedPointComplex (*result.complex, parameters.critical, log, result.found);
  if (status != Status::OK)
    return status;
  if (!log.begin ("rims", 0.7f))
    return Status::CANCELLED;
  SampleDimensions dimensions = computeDimensions (result.complex, RHO);
  dimensions.manifold_dimension.assign (dimensions.dimension.size (), 2);
  keepInside (*result.complex, result.found.facets, dimensions);
  const GivenCandidates given{result.found.facets, areProved (parameters.critical)};
  shape = extractShape (dimensions, parameters.watertight, log, &given);
  if (log.cancelled ())
    return Status::CANCELLED;
  return shape.triangles.empty () ? Status::DIMENSION_TOO_LOW : Status::OK;
}

Status
reconstruct (const Eigen::Matrix3Xd& points, const pcl::Indices& indices, double resolution,
             const FixedPointParameters& parameters, StageLog& log, FixedPointResult& result,
             SimplicialComplex& shape)
{
  std::shared_ptr<const SampleSet> samples;
  Status status = makeSamples (points, indices, resolution, parameters.thinning, log, samples);
  if (status != Status::OK)
    return status;
  if (samples->size () < 3)
    return Status::TOO_FEW_POINTS;
  status = triangulateSamples (samples, parameters.complex, parameters.threads, log, result.complex);
  if (status != Status::OK)
    return status;
  if (result.complex->affine_dimension < 2)
    return Status::DIMENSION_TOO_LOW;
  status = parameters.initial_mesh ? iterateFrom (*parameters.initial_mesh, log, result, shape)
                                   : extractFrom (parameters, log, result, shape);
  if (status != Status::OK)
    return status;
  if (!log.begin ("", 1.0f))
    return Status::CANCELLED;
  toInput (*samples, shape);
  return Status::OK;
}

} // namespace

Status
reconstructFixedPoint (const Eigen::Matrix3Xd& points, const pcl::Indices& indices, double resolution,
                       const FixedPointParameters& parameters, StageLog& log, FixedPointResult& result,
                       SimplicialComplex& shape) noexcept
{
  result = FixedPointResult ();
  shape.clear ();
  const Status status = guarded ([&] {
    Status inner = Status::OK;
    withThreads (parameters.threads,
                 [&] { inner = reconstruct (points, indices, resolution, parameters, log, result, shape); });
    return inner;
  });
  if (status != Status::OK) {
    result = FixedPointResult ();
    shape.clear ();
  }
  return status;
}

SimplicialComplex
facetShape (const DelaunayComplex& complex, const FacetFlags& facets)
{
  SimplicialComplex shape = trianglesOf (complex, facets);
  toInput (*complex.samples, shape);
  return shape;
}

} // namespace manifold
} // namespace pcl
