#pragma once

#include "scene.h"

#include <array>
#include <vector>

#include <vtkActor.h>
#include <vtkSmartPointer.h>

namespace pcl::manifold::apps {

/** \brief Takes positions to a cube around zero, so that coordinates of any size can be drawn. */
struct UnitFrame
{
  std::array<double, 3> centre{};
  double scale = 1; ///< half the largest extent

  template <typename Number>
  std::array<double, 3> operator() (const std::array<Number, 3>& position) const
  {
    return {(position[0] - centre[0]) / scale, (position[1] - centre[1]) / scale,
            (position[2] - centre[2]) / scale};
  }
};

/** \brief The frame that takes corners to the cube. */
UnitFrame frameOf (const std::vector<std::array<double, 3>>& corners);

/** \brief What VTK draws for a layer.
 * \param[in] pixel_scale factor for sizes in pixels */
vtkSmartPointer<vtkActor> makeActor (const Layer& layer, const UnitFrame& frame, double pixel_scale);

} // namespace pcl::manifold::apps
