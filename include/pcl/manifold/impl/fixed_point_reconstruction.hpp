#pragma once

#include <pcl/console/print.h>
#include <pcl/conversions.h>
#include <pcl/manifold/fixed_point_reconstruction.h>
#include <pcl/manifold/impl/cloud_points.hpp>
#include <pcl/manifold/impl/guarded_input.hpp>
#include <pcl/manifold/mesh_pieces.h>

template <typename PointT>
pcl::manifold::Status
pcl::FixedPointReconstruction<PointT>::compute (manifold::StageLog& log, pcl::SimplicialComplex& surface)
{
  manifold::FixedPointParameters parameters = parameters_;
  if (initial_mesh_) {
    const auto pieces = std::make_shared<manifold::FlatPieces> ();
    const manifold::Status status = manifold::meshPieces (*initial_mesh_, *pieces);
    if (status != manifold::Status::OK)
      return status;
    parameters.initial_mesh = pieces;
  }
  return manifold::reconstructFixedPoint (manifold::cloudPoints (*input_, *indices_), *indices_,
                                          manifold::FLOAT_RESOLUTION, parameters, log, result_, surface);
}

template <typename PointT>
void
pcl::FixedPointReconstruction<PointT>::reconstruct (pcl::SimplicialComplex& output)
{
  output.clear ();
  result_ = manifold::FixedPointResult ();
  manifold::StageLog log (parameters_.progress);
  status_ = manifold::onGuardedInput<PointT> (
    input_, indices_, [this] { return initCompute (); }, [this] { return deinitCompute (); },
    [&] { return compute (log, output); });
  stages_ = log.stages ();
  if (status_ != manifold::Status::OK)
    PCL_ERROR ("[pcl::FixedPointReconstruction::reconstruct] %s\n", manifold::toString (status_));
}

// The base class reads the input cloud before it asks whether there is one, so its functions are not called.

template <typename PointT>
void
pcl::FixedPointReconstruction<PointT>::reconstruct (pcl::PolygonMesh& output)
{
  performReconstruction (output);
}

template <typename PointT>
void
pcl::FixedPointReconstruction<PointT>::reconstruct (std::vector<pcl::Vertices>& polygons)
{
  performReconstruction (polygons);
}

template <typename PointT>
void
pcl::FixedPointReconstruction<PointT>::performReconstruction (pcl::PolygonMesh& output)
{
  output = pcl::PolygonMesh ();
  pcl::SimplicialComplex surface;
  reconstruct (surface);
  if (status_ != manifold::Status::OK)
    return;
  pcl::PCLPointCloud2 cloud;
  pcl::toPCLPointCloud2 (*input_, cloud);
  manifold::toPolygonMesh (surface, cloud, output);
  output.header = input_->header;
}

template <typename PointT>
void
pcl::FixedPointReconstruction<PointT>::performReconstruction (std::vector<pcl::Vertices>& polygons)
{
  pcl::PolygonMesh mesh;
  performReconstruction (mesh);
  polygons = std::move (mesh.polygons);
}
