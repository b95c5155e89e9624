#pragma once

#include <cloud_reader.h>

#include <pcl/conversions.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>

/** Real clouds, which are no part of the sources: a test whose file is absent is skipped. */
namespace real_data {

/** \brief A file of Debian's package libcgal-demo, which the test "demo_data" unpacks (cmake/demo_data.sh).
 * \param[in] name for example meshes/knot1.off
 * \return an empty name where it is not there */
inline std::string
demoFile (const std::string& name)
{
  const auto file = std::filesystem::path (PCL_MANIFOLD_DEMO_DATA) / name;
  return std::filesystem::exists (file) ? file.string () : std::string ();
}

/** \brief A file of the folder that the environment variable PCL_MANIFOLD_DATA names.
 * \return an empty name where it is not there */
inline std::string
dataFile (const std::string& name)
{
  const char* folder = std::getenv ("PCL_MANIFOLD_DATA");
  const auto file = std::filesystem::path (folder != nullptr ? folder : PCL_MANIFOLD_DATA_DEFAULT) / name;
  return std::filesystem::exists (file) ? file.string () : std::string ();
}

template <typename PointT>
typename pcl::PointCloud<PointT>::Ptr
readCloud (const std::string& file)
{
  const auto cloud = std::make_shared<pcl::PointCloud<PointT>> ();
  pcl::fromPCLPointCloud2 (pcl::manifold::apps::readCloud (file).cloud, *cloud);
  return cloud;
}

} // namespace real_data
