#pragma once

#include <Eigen/Geometry>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace generate {

class Random;

/** \brief What is known of a shape whatever its size. */
struct Topology
{
  int euler;               ///< Euler characteristic
  int boundary_components; ///< loops of a rim, ends of a curve, skins of a solid; 0 when closed
  bool orientable = true;
};

/** \brief The point of a shape that is nearest to a given one. */
struct Nearest
{
  Eigen::Vector3d point;
  Eigen::Vector3d
    normal;        ///< unit; of a surface or the skin of a solid (outward if closed); tangent of a curve
  double distance; ///< 0 or more
};

/** \brief A piece of a shape, the image of the unit interval, square or cube. */
struct Patch
{
  double measure;       ///< length, area or volume
  double density_bound; ///< upper bound of Shape::density over the piece
};

/** \brief A smooth curve, surface or solid (dimension 1, 2, 3), or some isolated points (0).
 *
 * Shapes are values. Everything that samples them needs but the patches and their maps. */
struct Shape
{
  std::string name;
  int dimension;
  Topology topology;

  std::vector<Patch> patches;
  /** \brief The point of the shape for a patch and a point of the unit cube, of which the first
   * `dimension` coordinates count. */
  std::function<Eigen::Vector3d (std::size_t patch, const Eigen::Vector3d& u)> point;
  /** \brief How much length, area or volume the map above makes of a unit of its domain, there. */
  std::function<double (std::size_t patch, const Eigen::Vector3d& u)> density;
  /** \brief How large a box of the domain becomes: two of its points are mapped no further apart than the
   * norm of the coefficient-wise product of this and their difference, divided by the size of the box. */
  std::function<Eigen::Vector3d (std::size_t patch, const Eigen::Vector3d& low, const Eigen::Vector3d& size)>
    extent;
  /** \brief The nearest point of the shape. Where a shape says so it is found by iteration and right only
   * near the shape, nearer than its feature size. */
  std::function<Nearest (const Eigen::Vector3d& point)> nearest;

  /** \brief A lower bound of the local feature size (the distance to the medial axis) over the whole shape;
   * infinity if it has no medial axis, 0 where none is known. */
  double feature_size = 0.0;

  /** \brief Parts of lower dimension that a sample has to cover for themselves: rim, ends, skin, corners. */
  std::vector<Shape> strata;

  /** \brief Length, area or volume; the number of points for dimension 0. */
  double measure () const;

  /** \brief Distance of a point of a solid to its skin; 0 for curves and surfaces. */
  double depth (const Eigen::Vector3d& point) const;
};

/** \brief Told how far a long computation is, a fraction in [0, 1] that never decreases. To cancel, it
 * throws. */
using Tick = std::function<void (double fraction)>;

/** \brief Draws points of a shape, uniformly in length, area or volume. */
class UniformDraw
{
public:
  /** \param[in] shape must outlive this object */
  explicit UniformDraw (const Shape& shape);

  Eigen::Vector3d operator() (Random& random) const;

private:
  const Shape& shape_;
  std::vector<double> cumulated_;
};

/** \brief The shape moved as a whole. */
Shape moved (const Shape& shape, const Eigen::Isometry3d& motion);

/** \brief The shape translated. */
Shape moved (const Shape& shape, const Eigen::Vector3d& offset);

/** \brief A shape of one patch; its measure comes from numerical integration of the density.
 * \param[in] stretch how large the whole domain becomes along each of its axes, as in Shape::extent; a box
 * gets its part of that Nearest point, feature size and strata are left to the caller. */
Shape parametric (const std::string& name, int dimension, const Topology& topology,
                  const Eigen::Vector3d& stretch, double density_bound,
                  std::function<Eigen::Vector3d (const Eigen::Vector3d& u)> point,
                  std::function<double (const Eigen::Vector3d& u)> density);

/** \brief Isolated points, a shape of dimension 0. */
Shape isolatedPoints (const std::string& name, const std::vector<Eigen::Vector3d>& points);

} // namespace generate
