#pragma once

#include <pcl/console/print.h>
#include <pcl/conversions.h>
#include <pcl/manifold/graph_reconstruction.h>
#include <pcl/manifold/impl/guarded_input.hpp>
#include <pcl/manifold/impl/represented_points.hpp>
#include <pcl/manifold/sample_set.h>

template <typename PointT>
pcl::manifold::NeighborSearch
pcl::GraphReconstruction<PointT>::givenSearch () const
{
  manifold::NeighborSearch search;
  if (!tree_)
    return search;
  search.prepare = [this] (const pcl::Indices& points) {
    tree_->setInputCloud (input_, pcl::make_shared<pcl::Indices> (points));
  };
  search.nearest = [this, distances = std::vector<float> ()] (pcl::index_t point, int count,
                                                              pcl::Indices& found) mutable {
    return tree_->nearestKSearch (*input_, point, count, found, distances);
  };
  return search;
}

template <typename PointT>
pcl::manifold::Status
pcl::GraphReconstruction<PointT>::makeGraph (manifold::StageLog& log)
{
  if (representation_ && !manifold::isWhole (*representation_))
    return manifold::Status::PARAMETER_OUT_OF_RANGE;
  if (indices_->empty ())
    return manifold::Status::NO_INPUT;
  Eigen::MatrixXd points = manifold::pointsOf (*input_, *indices_, representation_.get ());
  if (given_graph_) {
    const manifold::Status status =
      manifold::takeGraph (*given_graph_, *indices_, parameters_.threads, log, cloud_graph_);
    if (status == manifold::Status::OK)
      cloud_graph_.points = std::move (points);
    return status;
  }
  if (!representation_ && !manifold::HasCoordinates<PointT>::value)
    return manifold::Status::PARAMETER_OUT_OF_RANGE;
  return manifold::makeCloudGraph (std::move (points), *indices_, manifold::FLOAT_RESOLUTION,
                                   parameters_.k_search, givenSearch (), parameters_.threads, log,
                                   cloud_graph_);
}

template <typename PointT>
pcl::manifold::Status
pcl::GraphReconstruction<PointT>::compute (manifold::StageLog& log)
{
  cloud_graph_ = manifold::CloudGraph ();
  result_ = manifold::GraphMesh ();
  manifold::Status status;
  if (!input_ && given_graph_)
    status = manifold::takeGraph (*given_graph_, {}, parameters_.threads, log, cloud_graph_);
  else
    status = manifold::onGuardedInput<PointT> (
      input_, indices_, [this] { return initCompute (); }, [this] { return deinitCompute (); },
      [this, &log] { return makeGraph (log); });
  if (status == manifold::Status::OK)
    status = manifold::reconstructGraph (cloud_graph_.graph, cloud_graph_.points, parameters_, log, result_);
  if (status != manifold::Status::OK && status != manifold::Status::DIMENSION_TOO_LOW)
    cloud_graph_ = manifold::CloudGraph ();
  return status;
}

// The base class reads the input cloud before it asks whether there is one, so its functions are not called.

template <typename PointT>
void
pcl::GraphReconstruction<PointT>::reconstruct (pcl::PolygonMesh& output)
{
  performReconstruction (output);
}

template <typename PointT>
void
pcl::GraphReconstruction<PointT>::reconstruct (std::vector<pcl::Vertices>& polygons)
{
  performReconstruction (polygons);
}

template <typename PointT>
void
pcl::GraphReconstruction<PointT>::performReconstruction (pcl::PolygonMesh& output)
{
  output = pcl::PolygonMesh ();
  performReconstruction (output.polygons);
  if (status_ != manifold::Status::OK || !input_)
    return;
  pcl::toPCLPointCloud2 (*input_, output.cloud);
  output.header = input_->header;
}

template <typename PointT>
void
pcl::GraphReconstruction<PointT>::performReconstruction (std::vector<pcl::Vertices>& polygons)
{
  polygons.clear ();
  manifold::StageLog log (parameters_.progress);
  status_ = compute (log);
  stages_ = log.stages ();
  if (status_ == manifold::Status::OK)
    polygons = manifold::polygonsOf (result_, cloud_graph_.input_index);
  else
    PCL_ERROR ("[pcl::GraphReconstruction::reconstruct] %s\n", manifold::toString (status_));
}

template <typename PointT>
pcl::Indices
pcl::GraphReconstruction<PointT>::getLandmarks () const
{
  pcl::Indices landmarks;
  for (const pcl::index_t vertex : result_.landmarks)
    landmarks.push_back (cloud_graph_.input_index[vertex]);
  return landmarks;
}

template <typename PointT>
std::vector<pcl::index_t>
pcl::GraphReconstruction<PointT>::getTiles () const
{
  std::vector<pcl::index_t> tiles;
  for (const pcl::index_t vertex : cloud_graph_.vertex_of)
    tiles.push_back (vertex < 0 ? -1 : result_.tiles[vertex]);
  return tiles;
}
