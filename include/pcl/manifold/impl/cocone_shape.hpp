#pragma once

#include <pcl/manifold/cocone_shape.h>
#include <pcl/manifold/impl/cloud_points.hpp>

template <typename PointT>
pcl::manifold::Status
pcl::CoconeShape<PointT>::compute (manifold::StageLog& log, pcl::SimplicialComplex& complex)
{
  manifold::ShapeParameters parameters;
  this->setShared (parameters.dimension);
  parameters.dimension.rho = rho_;
  parameters.dimension.dimensions = given_dimensions_;
  parameters.watertight = this->getWatertight ();
  return manifold::reconstructShape (manifold::cloudPoints (*input_, *indices_), *indices_,
                                     manifold::FLOAT_RESOLUTION, parameters, log, dimensions_, complex);
}
