#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_representation.h>
#include <pcl/types.h>

#include <Eigen/Core>

#include <type_traits>
#include <utility>
#include <vector>

namespace pcl {
namespace manifold {

/** \brief Whether a point type has x, y and z. */
template <typename PointT, typename = void>
struct HasCoordinates : std::false_type
{};

template <typename PointT>
struct HasCoordinates<PointT, std::void_t<decltype (std::declval<const PointT&> ().getVector3fMap ())>>
  : std::true_type
{};

/** \brief Whether a representation gives all of a point: one vector of a dimension, and not the first three
 * floats of a larger one that has no x, y and z, as the default representation of histograms does. */
template <typename PointT>
bool
isWhole (const pcl::PointRepresentation<PointT>& representation)
{
  constexpr int FLOATS_BY_DEFAULT = 3;
  const bool is_default =
    dynamic_cast<const pcl::DefaultPointRepresentation<PointT>*> (&representation) != nullptr;
  const bool leaves_out = !HasCoordinates<PointT>::value &&
                          representation.getNumberOfDimensions () == FLOATS_BY_DEFAULT &&
                          sizeof (PointT) > FLOATS_BY_DEFAULT * sizeof (float);
  return representation.getNumberOfDimensions () > 0 && !(is_default && leaves_out);
}

/** \brief The vectors that a representation gives for those points of a cloud that the indices name. */
template <typename PointT>
Eigen::MatrixXd
representedPoints (const pcl::PointCloud<PointT>& cloud, const pcl::Indices& indices,
                   const pcl::PointRepresentation<PointT>& representation)
{
  std::vector<float> vector (static_cast<std::size_t> (representation.getNumberOfDimensions ()));
  Eigen::MatrixXd points (representation.getNumberOfDimensions (),
                          static_cast<Eigen::Index> (indices.size ()));
  for (std::size_t i = 0; i < indices.size (); ++i) {
    representation.vectorize (cloud[indices[i]], vector);
    for (std::size_t axis = 0; axis < vector.size (); ++axis)
      points (static_cast<Eigen::Index> (axis), static_cast<Eigen::Index> (i)) = vector[axis];
  }
  return points;
}

/** \brief The points as the representation gives them, or if it is null their x, y and z. Without columns
 * where there is neither. */
template <typename PointT>
Eigen::MatrixXd
pointsOf (const pcl::PointCloud<PointT>& cloud, const pcl::Indices& indices,
          const pcl::PointRepresentation<PointT>* representation)
{
  if (representation != nullptr)
    return representedPoints (cloud, indices, *representation);
  Eigen::MatrixXd points;
  if constexpr (HasCoordinates<PointT>::value) {
    points.resize (3, static_cast<Eigen::Index> (indices.size ()));
    for (std::size_t i = 0; i < indices.size (); ++i)
      points.col (static_cast<Eigen::Index> (i)) =
        cloud[indices[i]].getVector3fMap ().template cast<double> ();
  }
  return points;
}

} // namespace manifold
} // namespace pcl
