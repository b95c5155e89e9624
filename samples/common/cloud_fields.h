#pragma once

#include <pcl/PCLPointCloud2.h>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl::manifold::apps {

/** \brief The field of that name; nullptr if there is none. */
const pcl::PCLPointField* findField (const pcl::PCLPointCloud2& cloud, const std::string& name);

/** \brief Number of bytes that a field takes in a point. */
std::uint32_t fieldBytes (const pcl::PCLPointField& field);

/** \brief Appends a field to the description of a point, after all others, and makes the point larger by it.
 * The data is left as it is.
 * \param[in] datatype the type, of pcl::PCLPointField
 * \param[in] count number of values in a point */
void appendField (pcl::PCLPointCloud2& cloud, const std::string& name, std::uint8_t datatype,
                  std::uint32_t count = 1);

/** \brief Sizes the data for the described point and `width` times `height` points. */
void allocatePoints (pcl::PCLPointCloud2& cloud);

/** \brief The same cloud without padding: every named field, in its order, one right after the other, every
 * value bit for bit. Fields named "_" are padding too. */
pcl::PCLPointCloud2 packed (const pcl::PCLPointCloud2& cloud);

/** \brief Sets a field of one value per point: in the place of the field of that name, or after all others if
 * there is none. All others are kept bit for bit (and packed).
 *
 * `T` is std::uint8_t, std::int32_t, std::uint32_t, float or double.
 * \throws std::invalid_argument if `values` does not hold one value per point */
template <typename T>
void setField (pcl::PCLPointCloud2& cloud, const std::string& name, const std::vector<T>& values);

} // namespace pcl::manifold::apps
