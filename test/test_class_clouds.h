#pragma once

#include <generate/catalogue.h>
#include <generate/closed_surfaces.h>
#include <generate/curves.h>
#include <generate/sampling.h>

#include <pcl/manifold/status.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <memory>
#include <numeric>
#include <random>
#include <string>
#include <vector>

/** Clouds that both public classes of the Delaunay family are tested with. */
namespace class_clouds {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

constexpr float NOT_A_NUMBER = std::numeric_limits<float>::quiet_NaN ();

template <typename PointT = pcl::PointXYZ>
typename pcl::PointCloud<PointT>::Ptr
cloudOf (const std::vector<Eigen::Vector3f>& points)
{
  const auto cloud = std::make_shared<pcl::PointCloud<PointT>> ();
  for (const Eigen::Vector3f& p : points) {
    PointT point;
    point.x = p.x ();
    point.y = p.y ();
    point.z = p.z ();
    cloud->push_back (point);
  }
  return cloud;
}

inline std::vector<Eigen::Vector3f>
floats (const generate::LabelledCloud& cloud)
{
  std::vector<Eigen::Vector3f> points;
  for (const Eigen::Vector3d& p : cloud.points)
    points.push_back (p.cast<float> ());
  return points;
}

/** \brief A torus and, away from it, a knot: about 2000 points of dimension 2 and 70 of dimension 1. */
inline std::vector<Eigen::Vector3f>
torusAndKnot (std::uint64_t seed = 1)
{
  std::vector<Eigen::Vector3f> points = floats (generate::blueNoise (generate::torus (), 0.09, seed));
  for (const Eigen::Vector3f& p : floats (generate::blueNoise (generate::trefoil (), 0.09, seed)))
    points.push_back (p + Eigen::Vector3f (4.0f, 0.0f, 0.0f));
  return points;
}

inline std::vector<Eigen::Vector3f>
transformed (std::vector<Eigen::Vector3f> points, float scale, const Eigen::Vector3f& offset)
{
  for (Eigen::Vector3f& p : points)
    p = (p * scale + offset).eval ();
  return points;
}

/** \brief The points of a grid with these numbers of points along the axes. */
inline std::vector<Eigen::Vector3f>
grid (int nx, int ny, int nz)
{
  std::vector<Eigen::Vector3f> points;
  for (int x = 0; x < nx; ++x)
    for (int y = 0; y < ny; ++y)
      for (int z = 0; z < nz; ++z)
        points.emplace_back (static_cast<float> (x), static_cast<float> (y), static_cast<float> (z));
  return points;
}

/** \brief A seeded permutation of 0 .. n-1. */
inline std::vector<int>
permutation (std::size_t n)
{
  std::vector<int> order (n);
  std::iota (order.begin (), order.end (), 0);
  std::mt19937_64 engine (99);
  for (std::size_t i = n; i > 1; --i)
    std::swap (order[i - 1], order[engine () % i]);
  return order;
}

/** \brief Clouds that no method can make much of, with a name each. */
struct Named
{
  std::string name;
  std::vector<Eigen::Vector3f> points;
};

inline std::vector<Named>
degenerateClouds ()
{
  const std::vector<Eigen::Vector3f> line = grid (20, 1, 1);
  std::vector<Eigen::Vector3f> slanted;
  for (int i = 0; i < 30; ++i)
    slanted.push_back (Eigen::Vector3f (0.1f, 0.2f, 0.7f) * static_cast<float> (i * i % 31));
  const std::vector<Eigen::Vector3f> four = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  std::vector<Eigen::Vector3f> some_nan = torusAndKnot ();
  for (std::size_t i = 0; i < some_nan.size (); i += 3)
    some_nan[i][static_cast<int> (i % 3)] =
      i % 2 == 0 ? NOT_A_NUMBER : std::numeric_limits<float>::infinity ();
  return {
    {"one", {four[0]}},
    {"two", {four[0], four[1]}},
    {"three", {four[0], four[1], four[2]}},
    {"four", four},
    {"four in a plane", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}},
    {"all equal", std::vector<Eigen::Vector3f> (50, Eigen::Vector3f (1.0f, 2.0f, 3.0f))},
    {"collinear", line},
    {"collinear up to rounding", slanted},
    {"coplanar", grid (9, 8, 1)},
    {"grid", grid (6, 6, 6)},
    {"some not finite", some_nan},
    {"tiny", transformed (torusAndKnot (), 1e-30f, {0, 0, 0})},
    {"below the normal floats", transformed (torusAndKnot (), 1e-40f, {0, 0, 0})},
    {"huge", transformed (torusAndKnot (), 1e30f, {0, 0, 0})},
    {"as large as floats are", transformed (torusAndKnot (), 6e37f, {0, 0, 0})},
    {"far away", transformed (torusAndKnot (), 1.0f, {229885.0f, 5569975.0f, 2.0f})},
    {"tiny and huge",
     {{1e-38f, 0, 0}, {1e38f, 0, 0}, {0, 1e-38f, 0}, {0, 0, 3e38f}, {1, 1, 1}, {-3e38f, 2, 1}}},
  };
}

} // namespace class_clouds
