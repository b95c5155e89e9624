#pragma once

#include "test_must_show_models.h"

#include <generate/catalogue.h>
#include <generate/closed_surfaces.h>
#include <generate/random.h>
#include <generate/sampling.h>

#include <pcl/manifold/reconstruct_fixed_point.h>

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

/** What the tests of the published guarantee and the command evaluate_fixed_points share. */
namespace must_show {

/** \brief The guarantee holds for samples as dense as this share of the feature size. */
constexpr double GUARANTEED_EPS = 0.143;

/** \brief Names of smooth closed surfaces of different genus, with known feature size. */
inline const std::vector<std::string>&
smoothSurfaceNames ()
{
  static const std::vector<std::string> names = {"sphere",    "ellipsoid", "torus", "thin-torus",
                                                 "fat-torus", "genus2",    "genus3"};
  return names;
}

/** \brief A smooth closed surface. */
struct SmoothSurface
{
  generate::Shape shape;
  generate::FeatureSize feature_size;
  bool adaptive = true; ///< whether it is not the same nearly everywhere

  /** \brief An eps-sample, as sparse as may be. */
  Eigen::Matrix3Xd sample (double eps, std::uint64_t seed) const
  {
    return pointsOf (adaptive ? generate::adaptiveSample (shape, feature_size, eps, seed)
                              : generate::epsilonSample (shape, eps, seed));
  }
};

inline SmoothSurface
smoothSurface (const std::string& name)
{
  const auto torus = [] (double radius) {
    return SmoothSurface{
      generate::torus (1.0, radius),
      [radius] (const Eigen::Vector3d& place) { return generate::torusFeatureSize (radius, place); },
      radius > 0.5};
  };
  if (name == "torus")
    return torus (0.4);
  if (name == "thin-torus")
    return torus (0.2);
  if (name == "fat-torus")
    return torus (0.7);
  if (name == "ellipsoid") {
    const Eigen::Vector3d axes (1.0, 0.75, 0.5);
    return {generate::ellipsoid (axes),
            [axes] (const Eigen::Vector3d& place) { return generate::ellipsoidFeatureSize (axes, place); }};
  }
  const generate::Shape shape = generate::shapeByName (name);
  return {shape, [size = shape.feature_size] (const Eigen::Vector3d&) { return size; }, false};
}

/** \brief How far a triangle may be from the surface that was sampled. */
struct Closeness
{
  double distance = 0.0; ///< of its points, as a share of the feature size
  double angle = 0.0;    ///< between its plane and the tangent plane at the nearest place, in radians
};

/** \brief Theorem 13: what is proved for an eps-sample. */
inline Closeness
provedBounds (double eps)
{
  Closeness bounds;
  double& omega = bounds.distance;
  double lambda = eps;
  // The fixed point of Omega (Lemma 5): 17 digits take fewer than 30 rounds.
  for (int i = 0; i < 100; ++i) {
    lambda = eps * std::sqrt ((1.0 + omega) / (1.0 - omega));
    omega = 1.0 - std::sqrt (1.0 - std::pow (lambda / (1.0 - lambda), 2));
  }
  // Lemma 6; eta by its cosine, the square of which is 1 - lambda^2 / sqrt (1 - lambda^2).
  const double delta = std::hypot (omega, eps * (1.0 + omega)) / (1.0 - lambda);
  const double chi =
    std::asin (delta) + std::asin (2.0 / std::sqrt (3.0) * std::sin (2.0 * std::asin (delta)));
  const double square = lambda * lambda;
  const double eta = std::acos (std::sqrt (1.0 - square / std::sqrt (1.0 - square)));
  bounds.angle = chi + 2.0 * eta;
  return bounds;
}

/** \brief How far triangles are from the surface at most: at their corners, at the middles of their edges and
 * of themselves.
 * \param[in] points of the cloud that the complex is over */
inline Closeness
closenessOf (const pcl::SimplicialComplex& complex, const Eigen::Matrix3Xd& points,
             const SmoothSurface& surface)
{
  Closeness worst;
  for (const pcl::SimplicialComplex::Triangle& triangle : complex.triangles) {
    const Eigen::Vector3d a = points.col (triangle[0]), b = points.col (triangle[1]),
                          c = points.col (triangle[2]);
    const Eigen::Vector3d normal = (b - a).cross (c - a).normalized ();
    const std::array<Eigen::Vector3d, 7> places = {
      a, b, c, 0.5 * (a + b), 0.5 * (b + c), 0.5 * (c + a), (a + b + c) / 3.0};
    for (const Eigen::Vector3d& place : places) {
      const generate::Nearest nearest = surface.shape.nearest (place);
      worst.distance = std::max (worst.distance, nearest.distance / surface.feature_size (nearest.point));
      worst.angle =
        std::max (worst.angle, std::acos (std::min (1.0, std::abs (normal.dot (nearest.normal)))));
    }
  }
  return worst;
}

/** \brief A reconstruction by FixedPointReconstruction and its measures. */
struct FixedPointEvaluation
{
  Evaluation surface; ///< without dimensions
  pcl::manifold::FixedPointResult result;
};

/** \brief Reconstructs a cloud.
 * \param[in] complex of the same cloud, or null */
inline FixedPointEvaluation
reconstructFixedPoint (const Eigen::Matrix3Xd& points, const pcl::manifold::CriticalPointParameters& critical,
                       unsigned int threads = 0,
                       const std::shared_ptr<const pcl::manifold::DelaunayComplex>& complex = nullptr)
{
  pcl::manifold::FixedPointParameters parameters;
  parameters.critical = critical;
  parameters.threads = threads;
  parameters.complex = complex;
  pcl::manifold::StageLog log;
  FixedPointEvaluation evaluation;
  Evaluation& surface = evaluation.surface;
  const auto start = std::chrono::steady_clock::now ();
  surface.status = pcl::manifold::reconstructFixedPoint (points, {}, pcl::manifold::FLOAT_RESOLUTION,
                                                         parameters, log, evaluation.result, surface.shape);
  surface.seconds = std::chrono::duration<double> (std::chrono::steady_clock::now () - start).count ();
  if (surface.status == pcl::manifold::Status::OK)
    surface.samples = static_cast<std::size_t> (evaluation.result.complex->samples->size ());
  surface.topology = pcl::manifold::analyze (surface.shape);
  return evaluation;
}

/** \brief How many triangles of the result are not in the manifold fixed-point complex. */
inline std::size_t
countOutside (const FixedPointEvaluation& evaluation)
{
  using Triangles = std::vector<pcl::SimplicialComplex::Triangle>;
  Triangles result = evaluation.surface.shape.triangles;
  Triangles complex =
    pcl::manifold::facetShape (*evaluation.result.complex, evaluation.result.found.facets).triangles;
  for (Triangles* list : {&result, &complex}) {
    for (pcl::SimplicialComplex::Triangle& triangle : *list)
      std::sort (triangle.begin (), triangle.end ());
    std::sort (list->begin (), list->end ());
  }
  return static_cast<std::size_t> (std::count_if (result.begin (), result.end (), [&] (const auto& triangle) {
    return !std::binary_search (complex.begin (), complex.end (), triangle);
  }));
}

/** \brief What is wrong with the reconstruction of a 0.143-sample of a surface; empty if nothing is.
 * \param[out] closeness of all triangles of the manifold fixed-point complex */
inline std::string
guaranteeComplaints (const SmoothSurface& surface, const Eigen::Matrix3Xd& points,
                     const FixedPointEvaluation& evaluation, Closeness& closeness)
{
  std::string complaints = evaluation.surface.complaints (expectedOf (surface.shape, 1.0));
  if (!evaluation.result.complex)
    return complaints;
  if (const std::size_t outside = countOutside (evaluation))
    complaints += " " + std::to_string (outside) + " triangles outside of the complex";
  closeness = closenessOf (
    pcl::manifold::facetShape (*evaluation.result.complex, evaluation.result.found.facets), points, surface);
  const Closeness bounds = provedBounds (GUARANTEED_EPS);
  if (closeness.distance > bounds.distance)
    complaints += " distance " + std::to_string (closeness.distance) + " of the feature size";
  if (closeness.angle > bounds.angle)
    complaints += " angle " + std::to_string (closeness.angle);
  return complaints;
}

/** \brief Lemma 5: what is wrong with the fixed points that rough meshes in the sausage around a surface lead
 * to; empty if nothing is. Each mesh is the reconstruction with its vertices moved off the surface, at
 * random, by up to a share of the feature size; there are two, by up to 0.2 and 0.6 of it. */
inline std::string
sausageComplaints (const SmoothSurface& surface, const Eigen::Matrix3Xd& points,
                   const FixedPointEvaluation& evaluation, std::uint64_t seed)
{
  using namespace pcl::manifold;
  const DelaunayComplex& complex = *evaluation.result.complex;
  generate::Random random (seed);
  std::string complaints;
  for (const double share : {0.2, 0.6}) {
    FlatPieces mesh;
    mesh.vertices.resize (3, points.cols ());
    for (Eigen::Index i = 0; i < points.cols (); ++i) {
      const generate::Nearest nearest = surface.shape.nearest (points.col (i));
      const double offset = random.uniform (-share, share) * surface.feature_size (nearest.point);
      mesh.vertices.col (i) =
        (nearest.point + offset * nearest.normal - complex.samples->origin) * complex.samples->scale;
    }
    for (const auto& triangle : evaluation.surface.shape.triangles)
      mesh.triangles.push_back ({triangle[0], triangle[1], triangle[2]});
    FacetFlags start;
    if (restrictedDelaunay (complex, mesh, start) != Status::OK)
      return " rough mesh refused";
    const FixedPoint fixed = fixedPoint (complex, start);
    if (restrictedDelaunay (complex, fixed.facets) != fixed.facets)
      complaints += " no fixed point";
    for (std::size_t i = 0; i < fixed.facets.mask.size (); ++i)
      if ((fixed.facets.mask[i] & ~evaluation.result.found.facets.mask[i]) != 0) {
        complaints += " fixed point from " + std::to_string (share) + " outside of the complex";
        break;
      }
    if (facetShape (complex, fixed.facets).triangles.size () < evaluation.surface.shape.triangles.size ())
      complaints += " fixed point from " + std::to_string (share) + " with gaps";
  }
  return complaints;
}

} // namespace must_show
