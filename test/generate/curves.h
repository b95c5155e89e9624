#pragma once

#include <generate/shape.h>

#include <utility>

namespace generate {

/** \brief A curve t -> x (t) for t in [0, 1], with its nearest point by a search along it.
 * \param[in] velocity the derivative of \a position
 * \param[in] closed false adds the two ends as a stratum */
Shape spaceCurve (const std::string& name, bool closed,
                  const std::function<Eigen::Vector3d (double t)>& position,
                  const std::function<Eigen::Vector3d (double t)>& velocity);

/** \brief Straight edges between corners; the corners are a stratum.
 * \param[in] edges pairs of indices into \a corners */
Shape straightEdges (const std::string& name, const std::vector<Eigen::Vector3d>& corners,
                     const std::vector<std::pair<std::size_t, std::size_t>>& edges);

/** \brief Straight edges from each corner to the next and from the last to the first. */
Shape closedPolygon (const std::string& name, const std::vector<Eigen::Vector3d>& corners);

/** \brief A circle in the plane z = 0 about the origin. */
Shape circle (double radius = 1.0);

/** \brief The trefoil knot scale * (sin t + 2 sin 2t, cos t - 2 cos 2t, -sin 3t). Its feature size is at
 * least 0.6 * scale. */
Shape trefoil (double scale = 0.5);

/** \brief A helix about the z axis, from z = 0 upwards. */
Shape helix (double radius = 1.0, double pitch = 0.8, double turns = 3.0);

Shape segment (const Eigen::Vector3d& from = {-1.0, 0.0, 0.0}, const Eigen::Vector3d& to = {1.0, 0.0, 0.0});

/** \brief Position and first two derivatives of the trefoil, by its angle. */
struct CurveFrame
{
  Eigen::Vector3d position, velocity, acceleration;
};

CurveFrame trefoilFrame (double scale, double angle);

/** \brief Finds the nearest point of a curve by a table of its points and a search between them. */
class CurveSearch
{
public:
  CurveSearch (std::function<Eigen::Vector3d (double t)> position, std::size_t table_size);

  /** \brief The t in [0, 1] of the curve point nearest to \a p. */
  double operator() (const Eigen::Vector3d& p) const;

private:
  std::function<Eigen::Vector3d (double t)> position_;
  std::vector<Eigen::Vector3d> table_;
};

} // namespace generate
