#pragma once

#include "promises_case.h"

#include <pcl/manifold/cocone_shape.h>
#include <pcl/manifold/dimension_detection.h>
#include <pcl/manifold/fixed_point_reconstruction.h>
#include <pcl/manifold/graph_reconstruction.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <algorithm>
#include <map>
#include <memory>
#include <numeric>
#include <string>
#include <tuple>
#include <vector>

namespace promises {

using pcl::manifold::Status;
using Rows = std::vector<std::vector<int>>;

/** \brief What a class made of a cloud, so that two runs can be compared. */
struct Outcome
{
  Status status = Status::NOT_COMPUTED;
  Rows simplices;                          ///< edges, polygons, tetrahedra as they came
  std::vector<std::vector<double>> values; ///< per point what the class says of it, nothing on failure

  bool operator== (const Outcome& other) const
  {
    return status == other.status && simplices == other.simplices && values == other.values;
  }
};

inline pcl::PointCloud<pcl::PointXYZ>::Ptr
cloudOf (const std::vector<Eigen::Vector3f>& points)
{
  const auto cloud = std::make_shared<pcl::PointCloud<pcl::PointXYZ>> ();
  for (const Eigen::Vector3f& point : points)
    cloud->push_back (pcl::PointXYZ (point.x (), point.y (), point.z ()));
  return cloud;
}

inline void
setUp (pcl::DimensionDetection<pcl::PointXYZ>& object, const Case& input)
{
  object.setRho (input.rho);
  object.setThinningNeighbors (input.thinning_neighbors);
  object.setThinningDistance (input.thinning_distance);
}

inline void
setUp (pcl::CoconeShape<pcl::PointXYZ>& object, const Case& input)
{
  object.setRho (input.rho);
  object.setThinningNeighbors (input.thinning_neighbors);
  object.setThinningDistance (input.thinning_distance);
  object.setWatertight (input.watertight);
}

inline void
setUp (pcl::FixedPointReconstruction<pcl::PointXYZ>& object, const Case& input)
{
  object.setCriticalRatio (input.ratio);
  object.setVotes (input.votes);
  object.setThinningNeighbors (input.thinning_neighbors);
  object.setThinningDistance (input.thinning_distance);
  object.setWatertight (input.watertight);
}

inline void
setUp (pcl::GraphReconstruction<pcl::PointXYZ>& object, const Case& input)
{
  object.setKSearch (input.neighbors);
  object.setHops (input.hops);
  object.setAdjacencyThreshold (input.threshold);
  object.setAdjacencyRule (static_cast<pcl::manifold::AdjacencyRule> (input.rule));
  object.setMaximumFaceLength (input.longest_face);
  object.setFaceRule (input.shortest_cycles ? pcl::manifold::FaceRule::SHORTEST_CYCLES
                                            : pcl::manifold::FaceRule::ROTATION_SYSTEM);
  object.setRefine (input.refine);
  object.setTriangulate (input.triangulate);
  object.setSeed (input.seed);
}

/** \brief The first point that is the same place, for every point; a point that is not finite for itself. */
inline std::vector<int>
firstOfSame (const std::vector<Eigen::Vector3f>& points)
{
  std::map<std::tuple<float, float, float>, int> first;
  std::vector<int> same;
  for (std::size_t i = 0; i < points.size (); ++i) {
    const int number = static_cast<int> (i);
    const Eigen::Vector3f& p = points[i];
    same.push_back (p.allFinite () ? first.try_emplace ({p.x (), p.y (), p.z ()}, number).first->second
                                   : number);
  }
  return same;
}

/** \brief The simplices as sorted sets of renumbered vertices, in order. */
inline Rows
renumbered (Rows rows, const std::vector<int>& number)
{
  for (std::vector<int>& row : rows) {
    for (int& vertex : row)
      vertex = number[static_cast<std::size_t> (vertex)];
    std::sort (row.begin (), row.end ());
  }
  std::sort (rows.begin (), rows.end ());
  return rows;
}

/** \brief Runs a class with one thread, with two, and on the points in another order.
 * \param[in] run (case, threads, check), of which `check` asks for what is promised of one run
 * \return what was broken, or nothing */
template <typename Run>
std::string
brokenByThreadsOrOrder (const Case& input, const Run& run)
{
  std::string broken;
  const Outcome one = run (input, 1U, &broken);
  if (!broken.empty ())
    return broken;
  if (!(run (input, 2U, nullptr) == one))
    return "two threads give another result";

  // The order: every so many points, where that number has no factor in common with theirs.
  const std::size_t n = input.points.size ();
  std::size_t step = 7;
  while (n > 0 && std::gcd (step, n) != 1)
    ++step;
  Case other = input;
  std::vector<int> back (n);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t from = (i * step + 3) % n;
    other.points[i] = input.points[from];
    back[i] = static_cast<int> (from);
  }
  const std::vector<int> same = firstOfSame (input.points);
  for (int& number : back)
    number = same[static_cast<std::size_t> (number)];
  const Outcome moved = run (other, 1U, nullptr);
  if (moved.status != one.status)
    return std::string ("another order of the points ends in ") + pcl::manifold::toString (moved.status) +
           ", not " + pcl::manifold::toString (one.status);
  if (renumbered (moved.simplices, back) != renumbered (one.simplices, same))
    return "another order of the points gives other simplices";
  for (std::size_t i = 0; i < moved.values.size (); ++i)
    if (moved.values[i] != one.values[static_cast<std::size_t> (back[i])])
      return "another order of the points gives point " + std::to_string (back[i]) + " other values";
  return {};
}

} // namespace promises
