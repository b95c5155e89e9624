#pragma once

#include <pcl/PCLPointCloud2.h>

#include <string>

namespace pcl::manifold::apps {

/** \brief Reads the vertices of an OFF file (text; OFF, COFF, NOFF and the like) as a cloud with FLOAT64
 * coordinates. What else a vertex carries, and the faces, are not read.
 * \throws AppError if the file is missing, truncated or corrupt; it says where */
pcl::PCLPointCloud2 readOffVertices (const std::string& file);

} // namespace pcl::manifold::apps
