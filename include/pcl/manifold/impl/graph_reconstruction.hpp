#pragma once

#include <pcl/conversions.h>
#include <pcl/manifold/graph_reconstruction.h>
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
      manifold::takeGraph (*given_graph_, *indices_, this->getNumberOfThreads (), log, cloud_graph_);
    if (status == manifold::Status::OK)
      cloud_graph_.points = std::move (points);
    return status;
  }
  if (!representation_ && !manifold::HasCoordinates<PointT>::value)
    return manifold::Status::PARAMETER_OUT_OF_RANGE;
  return manifold::makeCloudGraph (std::move (points), *indices_, manifold::FLOAT_RESOLUTION,
                                   parameters_.k_search, givenSearch (), this->getNumberOfThreads (), log,
                                   cloud_graph_);
}

template <typename PointT>
pcl::manifold::Status
pcl::GraphReconstruction<PointT>::compute (manifold::StageLog& log)
{
  manifold::Status status;
  if (!input_ && given_graph_)
    status = manifold::takeGraph (*given_graph_, {}, this->getNumberOfThreads (), log, cloud_graph_);
  else
    status = this->withInput ([this, &log] { return makeGraph (log); });
  if (status != manifold::Status::OK)
    return status;
  manifold::GraphParameters parameters = parameters_;
  parameters.threads = this->getNumberOfThreads ();
  return manifold::reconstructGraph (cloud_graph_.graph, cloud_graph_.points, parameters, log, result_);
}

template <typename PointT>
template <typename Convert>
bool
pcl::GraphReconstruction<PointT>::reconstructAnd (const Convert& convert)
{
  const auto forget = [this] {
    cloud_graph_ = manifold::CloudGraph ();
    result_ = manifold::GraphMesh ();
  };
  forget ();
  const bool done = this->run ("GraphReconstruction::reconstruct", [&] (manifold::StageLog& log) {
    const manifold::Status status = compute (log);
    return status == manifold::Status::OK ? convert () : status;
  });
  if (!done && this->getStatus () != manifold::Status::DIMENSION_TOO_LOW)
    forget ();
  return done;
}

// The base class reads the input cloud before it asks whether there is one, so its functions are not called.

template <typename PointT>
void
pcl::GraphReconstruction<PointT>::reconstruct (pcl::PolygonMesh& output)
{
  output = pcl::PolygonMesh ();
  const bool done = reconstructAnd ([&] {
    output.polygons = manifold::polygonsOf (result_, cloud_graph_.input_index);
    if (input_) {
      pcl::toPCLPointCloud2 (*input_, output.cloud);
      output.header = input_->header;
    }
    return manifold::Status::OK;
  });
  if (!done)
    output = pcl::PolygonMesh ();
}

template <typename PointT>
void
pcl::GraphReconstruction<PointT>::reconstruct (std::vector<pcl::Vertices>& polygons)
{
  polygons.clear ();
  const bool done = reconstructAnd ([&] {
    polygons = manifold::polygonsOf (result_, cloud_graph_.input_index);
    return manifold::Status::OK;
  });
  if (!done)
    polygons.clear ();
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
