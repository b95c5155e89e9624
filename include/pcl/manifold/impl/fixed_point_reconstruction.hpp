#pragma once

#include <pcl/manifold/fixed_point_reconstruction.h>
#include <pcl/manifold/impl/cloud_points.hpp>
#include <pcl/manifold/mesh_pieces.h>

template <typename PointT>
pcl::manifold::Status
pcl::FixedPointReconstruction<PointT>::compute (manifold::StageLog& log, pcl::SimplicialComplex& complex)
{
  manifold::FixedPointParameters parameters;
  this->setShared (parameters);
  parameters.critical = critical_;
  parameters.watertight = this->getWatertight ();
  if (initial_mesh_) {
    const auto pieces = std::make_shared<manifold::FlatPieces> ();
    const manifold::Status status = manifold::meshPieces (*initial_mesh_, *pieces);
    if (status != manifold::Status::OK)
      return status;
    parameters.initial_mesh = pieces;
  }
  return manifold::reconstructFixedPoint (manifold::cloudPoints (*input_, *indices_), *indices_,
                                          manifold::FLOAT_RESOLUTION, parameters, log, result_, complex);
}
