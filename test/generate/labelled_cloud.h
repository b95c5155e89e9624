#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace generate {

/** \brief Points with the truth about each of them. All vectors are of the same length. */
struct LabelledCloud
{
  std::vector<Eigen::Vector3d> points;
  std::vector<std::uint32_t> labels; ///< dimension of the manifold that the point lies on: 1, 2 or 3
  std::vector<double> depth;         ///< distance of a point of a solid to its skin; 0 on curves and surfaces
  std::vector<std::uint8_t> boundary; ///< 1 on the rim of a surface, the ends of a curve, the skin of a solid
  std::vector<std::uint32_t> object;  ///< which shape of a scene, or which class of thing in a lidar sweep

  std::size_t size () const { return points.size (); }

  void add (const Eigen::Vector3d& point, std::uint32_t label, double point_depth = 0.0,
            bool on_boundary = false, std::uint32_t point_object = 0);

  /** \brief Adds all points of another cloud, their objects numbered on by \a first_object. */
  void append (const LabelledCloud& other, std::uint32_t first_object = 0);
};

/** \brief Moves every point by an isotropic Gaussian.
 * \param[in] sigma standard deviation of each coordinate, 0 or more; std::invalid_argument otherwise
 * The truth (labels, depth, boundary) stays that of the point before. */
void addNoise (LabelledCloud& cloud, double sigma, std::uint64_t seed);

} // namespace generate
