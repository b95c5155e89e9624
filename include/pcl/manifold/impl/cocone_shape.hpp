#pragma once

#include <pcl/console/print.h>
#include <pcl/conversions.h>
#include <pcl/manifold/cocone_shape.h>
#include <pcl/manifold/impl/cloud_points.hpp>
#include <pcl/manifold/impl/guarded_input.hpp>

template <typename PointT>
void
pcl::CoconeShape<PointT>::reconstruct (pcl::SimplicialComplex& output)
{
  output.clear ();
  dimensions_.reset ();
  stages_.clear ();
  manifold::StageLog log (parameters_.dimension.progress);
  status_ = manifold::onGuardedInput<PointT> (
    input_, indices_, [this] { return initCompute (); }, [this] { return deinitCompute (); },
    [&] {
      return manifold::reconstructShape (manifold::cloudPoints (*input_, *indices_), *indices_,
                                         manifold::FLOAT_RESOLUTION, parameters_, log, dimensions_, output);
    });
  stages_ = log.stages ();
  if (status_ != manifold::Status::OK)
    PCL_ERROR ("[pcl::CoconeShape::reconstruct] %s\n", manifold::toString (status_));
}

// The base class reads the input cloud before it asks whether there is one, so its functions are not called.

template <typename PointT>
void
pcl::CoconeShape<PointT>::reconstruct (pcl::PolygonMesh& output)
{
  performReconstruction (output);
}

template <typename PointT>
void
pcl::CoconeShape<PointT>::reconstruct (std::vector<pcl::Vertices>& polygons)
{
  performReconstruction (polygons);
}

template <typename PointT>
void
pcl::CoconeShape<PointT>::performReconstruction (pcl::PolygonMesh& output)
{
  output = pcl::PolygonMesh ();
  pcl::SimplicialComplex shape;
  reconstruct (shape);
  if (status_ != manifold::Status::OK)
    return;
  pcl::PCLPointCloud2 cloud;
  pcl::toPCLPointCloud2 (*input_, cloud);
  manifold::toPolygonMesh (shape, cloud, output);
  output.header = input_->header;
}

template <typename PointT>
void
pcl::CoconeShape<PointT>::performReconstruction (std::vector<pcl::Vertices>& polygons)
{
  pcl::PolygonMesh mesh;
  performReconstruction (mesh);
  polygons = std::move (mesh.polygons);
}
