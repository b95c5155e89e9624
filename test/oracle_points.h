#pragma once

#include "oracle_graph.h"

#include <Eigen/Core>

#include <cmath>

namespace oracle {

/** \brief A few of many kinds of points in R^d: on a raster, on a line, in clusters, of any size. */
inline Eigen::MatrixXd
randomPoints (int dimension, int count, Random& random)
{
  const int kind = random.index (6);
  Eigen::VectorXd direction (dimension);
  for (double& x : direction)
    x = random.uniform (-1, 1);
  Eigen::MatrixXd points (dimension, count);
  for (Eigen::Index i = 0; i < points.cols (); ++i) {
    for (int axis = 0; axis < dimension; ++axis)
      points (axis, i) = random.uniform (-1, 1);
    if (kind == 1) // on a raster, with ties and duplicates
      points.col (i) = (3.0 * points.col (i)).array ().round () * 0.1;
    else if (kind == 2)
      points.col (i) = points (0, i) * direction;
    else if (kind == 3) // clusters of very different size
      points.col (i) = points.col (i) * std::ldexp (1.0, -40 * random.index (4)) +
                       Eigen::VectorXd::Constant (dimension, random.index (3));
  }
  if (kind == 4)
    points *= std::ldexp (1.0, random.integer (-540, 500));
  return points;
}

/** \brief Per point its k nearest neighbours, or all others, by comparing the distances to all, in ascending
 * order; of equally near ones those of smaller index. */
inline NeighborhoodGraph
nearestByLookingAtAll (const Eigen::MatrixXd& points, int k)
{
  const auto n = static_cast<std::size_t> (points.cols ());
  std::vector<std::vector<index_t>> rows (n);
  for (std::size_t i = 0; i < n; ++i) {
    std::vector<std::pair<double, index_t>> others;
    for (std::size_t j = 0; j < n; ++j) {
      double squared = 0.0;
      for (Eigen::Index axis = 0; axis < points.rows (); ++axis) {
        const double difference =
          points (axis, static_cast<Eigen::Index> (j)) - points (axis, static_cast<Eigen::Index> (i));
        squared += difference * difference;
      }
      if (j != i)
        others.emplace_back (squared, static_cast<index_t> (j));
    }
    const std::size_t count = std::min (others.size (), static_cast<std::size_t> (k));
    std::partial_sort (others.begin (), others.begin () + static_cast<std::ptrdiff_t> (count), others.end ());
    others.resize (count);
    for (const auto& [distance, j] : others)
      rows[i].push_back (j);
    std::sort (rows[i].begin (), rows[i].end ());
  }
  return graphOfRows (rows);
}

} // namespace oracle
