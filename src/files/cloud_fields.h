#pragma once

#include "files/scalar_type.h"

#include <pcl/PCLPointCloud2.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl::manifold {

/** \brief One field of a cloud as files hold it. A colour that the cloud packs into four bytes is three or
 * four values of one byte, red first. */
struct CloudField
{
  std::string name;
  ScalarType type = 0;    ///< never BOOL
  std::size_t count = 1;  ///< values a point
  std::size_t offset = 0; ///< in a point's bytes
  bool packed_color = false;

  std::size_t size () const { return count * sizeOf (type); }

  /** \brief Copies the field's size () bytes out of a point. */
  void copy (const std::uint8_t* point, std::uint8_t* out) const;
};

/** \brief Where the fields of a consistent cloud are, and its points. */
class CloudFields
{
public:
  /** \param[in] cloud must outlive this object
   * \throw FileError if the cloud contradicts itself, has a field twice or has points without fields */
  explicit CloudFields (const pcl::PCLPointCloud2& cloud);

  std::size_t points () const { return points_; }

  /** \brief More than one for an organised cloud. */
  std::size_t rows () const { return cloud_.height; }

  /** \brief All fields but padding, in the cloud's order. */
  const std::vector<CloudField>& fields () const { return fields_; }

  /** \brief All fields but x, y and z. */
  std::vector<CloudField> attributes () const;

  /** \brief The fields x, y and z. \throw FileError if one is missing, though there are points */
  std::array<CloudField, 3> coordinates () const;

  const std::uint8_t* point (std::size_t i) const { return cloud_.data.data () + i * cloud_.point_step; }

private:
  const pcl::PCLPointCloud2& cloud_;
  std::size_t points_ = 0;
  std::vector<CloudField> fields_;
};

/** \brief The values of one field for all points of a file. */
struct CloudColumn
{
  std::string name;
  ScalarType type = 0;
  std::size_t count = 1;
  std::vector<std::uint8_t> data; ///< points * count values
};

/** \brief A cloud of some columns. A column `rgb` of three bytes or `rgba` of four is packed.
 * \throw FileError for more points or bytes than a cloud can have */
pcl::PCLPointCloud2 makeCloud (const std::vector<CloudColumn>& columns, std::size_t points);

/** \brief The field of that name; nullptr if there is none. */
const pcl::PCLPointField* findField (const pcl::PCLPointCloud2& cloud, const std::string& name);

/** \brief Appends a field to the description of a point, after all others, and makes the point larger by it.
 * The data is left as it is. */
void appendField (pcl::PCLPointCloud2& cloud, const std::string& name, ScalarType type,
                  std::size_t count = 1);

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

} // namespace pcl::manifold
