#pragma once

#include <pcl/point_types.h>
#include <pcl/register_point_struct.h>

#include <Eigen/Core>

/** \brief A point type that PCL's libraries know nothing of. */
struct SurveyPoint
{
  PCL_ADD_POINT4D;
  float reflectance;
  PCL_MAKE_ALIGNED_OPERATOR_NEW
};

POINT_CLOUD_REGISTER_POINT_STRUCT (SurveyPoint, (float, x, x) (float, y, y) (float, z, z) (float, reflectance,
                                                                                           reflectance))
