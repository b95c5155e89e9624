#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace benchmark {

/** \brief A cloud to reconstruct, made when it is needed. */
struct GraphModel
{
  std::string name;
  std::function<pcl::PointCloud<pcl::PointXYZ>::Ptr ()> points;
};

/** \brief The clouds of files, separated by commas. */
std::vector<GraphModel> modelsOfFiles (const std::string& files);

/** \brief Generated clouds: every shape with every number of points.
 * \param[in] shapes, sizes separated by commas
 * \param[in] even blue noise instead of independent points
 * \param[in] seed of the points
 * \throws std::exception for a shape or a number that is none */
std::vector<GraphModel> generatedModels (const std::string& shapes, const std::string& sizes, bool even,
                                         std::uint64_t seed);

/** \brief The parts of a list. */
std::vector<std::string> splitAtCommas (const std::string& list);

/** \brief The whole numbers of a list such as 3,5-8. */
std::vector<int> numbersOf (const std::string& list);

} // namespace benchmark
