#include <pcl/manifold/detail/reconstruct_fixed_point.h>

#include "common/guarded.h"
#include "common/parallel.h"
#include "delaunay/sampled_complex.h"
#include "extraction/extract_shape.h"
#include "extraction/to_input.h"
#include "fixed_point/facet_flags.h"
#include "voronoi/dimension.h"

#include <utility>

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
  shape = extractShape (dimensions, parameters.watertight, log, &result.found.facets);
  return log.cancelled () ? Status::CANCELLED : Status::OK;
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
