#pragma once

#include "scene.h"

#include <pcl/manifold/simplicial_complex.h>

namespace pcl::manifold::apps {

/** \brief The x, y, z of a cloud, whose coordinates are FLOAT32 as readCloud () leaves them. */
std::shared_ptr<const Positions> positionsOf (const pcl::PCLPointCloud2& cloud);

/** \brief What a picture shows of a complex: its edges, its triangles, and the boundary of its tetrahedra, in
 * the colours of their dimensions.
 * \param[in] positions those of the cloud that the complex is over
 * \param[in] complex its indices are valid for the positions */
std::vector<Layer> layersOf (const std::shared_ptr<const Positions>& positions,
                             const pcl::SimplicialComplex& complex);

} // namespace pcl::manifold::apps
