#include "files/cloud_fields.h"

#include "files/file_error.h"

#include <pcl/types.h>

#include <pcl/point_traits.h>

#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <utility>

namespace pcl::manifold {
namespace {

/** \brief Where red, green, blue and alpha lie among the bytes of a packed colour, 0xAARRGGBB. */
constexpr std::size_t color_bytes[4] = {host_is_big_endian ? 1 : 2, host_is_big_endian ? 2 : 1,
                                        host_is_big_endian ? 3 : 0, host_is_big_endian ? 0 : 3};

bool
isPackedColor (const pcl::PCLPointField& field)
{
  return (field.name == "rgb" || field.name == "rgba") && field.count <= 1 &&
         (field.datatype == pcl::PCLPointField::FLOAT32 || field.datatype == pcl::PCLPointField::UINT32);
}

bool
isColorColumn (const CloudColumn& column)
{
  return column.type == pcl::PCLPointField::UINT8 &&
         ((column.name == "rgb" && column.count == 3) || (column.name == "rgba" && column.count == 4));
}

bool
isDense (const CloudFields& fields)
{
  for (const CloudField& field : fields.fields ()) {
    if (field.name != "x" && field.name != "y" && field.name != "z")
      continue;
    for (std::size_t i = 0; i < fields.points (); ++i)
      if (!std::isfinite (toDouble (field.type, fields.point (i) + field.offset)))
        return false;
  }
  return true;
}

/** \brief Values in a point; a count of 0 stands for 1 in the oldest messages. */
std::size_t
countOf (const pcl::PCLPointField& field)
{
  return std::max<std::size_t> (field.count, 1);
}

/** \brief The same points without padding; a field of this name has another type, is there if it was not, and is not
 * filled. No field has an empty name. */
pcl::PCLPointCloud2
repack (const pcl::PCLPointCloud2& cloud, const std::string& name = {}, ScalarType type = 0)
{
  pcl::PCLPointCloud2 result;
  result.header = cloud.header;
  result.width = cloud.width;
  result.height = cloud.height;
  result.is_bigendian = cloud.is_bigendian;
  result.is_dense = cloud.is_dense;
  std::vector<std::pair<const pcl::PCLPointField*, std::size_t>> copies; // and where they go
  for (const pcl::PCLPointField& field : cloud.fields) {
    if (field.name == "_" || (field.name == name && findField (result, name) != nullptr))
      continue;
    if (field.name != name)
      copies.emplace_back (&field, result.point_step);
    appendField (result, field.name, field.name == name ? type : field.datatype,
                 field.name == name ? 1 : countOf (field));
  }
  if (!name.empty () && findField (result, name) == nullptr)
    appendField (result, name, type);
  allocatePoints (result);
  for (const auto& [field, offset] : copies) {
    if (result.data.empty ())
      break;
    std::uint8_t* to = result.data.data () + offset;
    for (std::size_t row = 0; row < cloud.height; ++row)
      for (std::size_t column = 0; column < cloud.width; ++column, to += result.point_step)
        std::memcpy (to, &cloud.data[row * cloud.row_step + column * cloud.point_step + field->offset],
                     countOf (*field) * sizeOf (field->datatype));
  }
  return result;
}

} // namespace

const pcl::PCLPointField*
findField (const pcl::PCLPointCloud2& cloud, const std::string& name)
{
  const auto found = std::find_if (cloud.fields.begin (), cloud.fields.end (),
                                   [&name] (const pcl::PCLPointField& field) { return field.name == name; });
  return found == cloud.fields.end () ? nullptr : &*found;
}

void
appendField (pcl::PCLPointCloud2& cloud, const std::string& name, ScalarType type, std::size_t count)
{
  pcl::PCLPointField field;
  field.name = name;
  field.datatype = type;
  field.count = static_cast<pcl::uindex_t> (count);
  field.offset = cloud.point_step;
  cloud.point_step += static_cast<pcl::uindex_t> (count * sizeOf (type));
  cloud.fields.push_back (field);
}

void
allocatePoints (pcl::PCLPointCloud2& cloud)
{
  cloud.row_step = cloud.point_step * cloud.width; // wraps for one row of more than 4 GB, which nothing reads
  cloud.data.resize (static_cast<std::size_t> (cloud.point_step) * cloud.width * cloud.height);
}

pcl::PCLPointCloud2
packed (const pcl::PCLPointCloud2& cloud)
{
  return repack (cloud);
}

template <typename T>
void
setField (pcl::PCLPointCloud2& cloud, const std::string& name, const std::vector<T>& values)
{
  const std::size_t points = static_cast<std::size_t> (cloud.width) * cloud.height;
  if (values.size () != points)
    throw std::invalid_argument ("field '" + name + "' has " + std::to_string (values.size ()) +
                                 " values for " + std::to_string (points) + " points");
  pcl::PCLPointCloud2 result = repack (cloud, name, pcl::traits::asEnum_v<T>);
  std::uint8_t* to = result.data.data () + findField (result, name)->offset;
  for (std::size_t i = 0; i < points; ++i)
    std::memcpy (to + i * result.point_step, &values[i], sizeof (T));
  cloud = std::move (result);
}

template void setField (pcl::PCLPointCloud2&, const std::string&, const std::vector<std::uint8_t>&);
template void setField (pcl::PCLPointCloud2&, const std::string&, const std::vector<std::int32_t>&);
template void setField (pcl::PCLPointCloud2&, const std::string&, const std::vector<std::uint32_t>&);
template void setField (pcl::PCLPointCloud2&, const std::string&, const std::vector<float>&);
template void setField (pcl::PCLPointCloud2&, const std::string&, const std::vector<double>&);

void
CloudField::copy (const std::uint8_t* point, std::uint8_t* out) const
{
  if (!packed_color)
    std::memcpy (out, point + offset, size ());
  else
    for (std::size_t channel = 0; channel < count; ++channel)
      out[channel] = point[offset + color_bytes[channel]];
}

CloudFields::CloudFields (const pcl::PCLPointCloud2& cloud)
  : cloud_ (cloud), points_ (static_cast<std::size_t> (cloud.width) * cloud.height)
{
  std::set<std::string> names;
  for (const pcl::PCLPointField& field : cloud.fields) {
    if (field.name == "_")
      continue;
    if (!isScalarType (field.datatype))
      throw FileError ("the cloud's field " + field.name + " is of an unknown type");
    if (field.name.empty ())
      throw FileError ("the cloud has a field without a name");
    if (!names.insert (field.name).second)
      throw FileError ("the cloud has two fields " + field.name);
    const std::size_t values = countOf (field);
    if (field.offset + values * sizeOf (field.datatype) > cloud.point_step)
      throw FileError ("the cloud's field " + field.name + " is outside of its points");
    CloudField own{field.name, field.datatype, values, field.offset, isPackedColor (field)};
    if (own.packed_color)
      own.count = field.name == "rgba" ? 4 : 3;
    if (own.packed_color || own.type == pcl::PCLPointField::BOOL)
      own.type = pcl::PCLPointField::UINT8;
    fields_.push_back (own);
  }
  if (points_ > 0 && fields_.empty ())
    throw FileError ("the cloud has points without fields");
  if (cloud.point_step > 0 && cloud.data.size () / cloud.point_step < points_)
    throw FileError ("the cloud has less data than points");
}

std::vector<CloudField>
CloudFields::attributes () const
{
  std::vector<CloudField> rest;
  for (const CloudField& field : fields_)
    if (field.name != "x" && field.name != "y" && field.name != "z")
      rest.push_back (field);
  return rest;
}

std::array<CloudField, 3>
CloudFields::coordinates () const
{
  std::array<CloudField, 3> xyz;
  const char* const names[3] = {"x", "y", "z"};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto field = std::find_if (fields_.begin (), fields_.end (),
                                     [&] (const CloudField& f) { return f.name == names[k]; });
    if (field != fields_.end ())
      xyz[k] = *field;
    else if (points_ > 0)
      throw FileError (std::string ("the cloud has no field ") + names[k]);
    else
      xyz[k] = {names[k], pcl::PCLPointField::FLOAT32, 1, 0, false};
  }
  return xyz;
}

pcl::PCLPointCloud2
makeCloud (const std::vector<CloudColumn>& columns, std::size_t points)
{
  if (points > static_cast<std::size_t> (std::numeric_limits<pcl::index_t>::max ()))
    throw FileError ("more points than a cloud can have");
  pcl::PCLPointCloud2 cloud;
  std::size_t bytes = 0;
  for (const CloudColumn& column : columns)
    bytes += column.count * sizeOf (column.type);
  if (bytes > std::numeric_limits<pcl::uindex_t>::max ())
    throw FileError ("more bytes a point than a cloud can have");
  for (const CloudColumn& column : columns)
    if (isColorColumn (column))
      appendField (cloud, column.name,
                   column.count == 4 ? pcl::PCLPointField::UINT32 : pcl::PCLPointField::FLOAT32);
    else
      appendField (cloud, column.name, column.type, column.count);
  cloud.height = 1;
  cloud.width = static_cast<pcl::uindex_t> (points);
  allocatePoints (cloud);
  const std::size_t step = cloud.point_step;
  for (std::size_t c = 0; c < columns.size () && points > 0; ++c) {
    const CloudColumn& column = columns[c];
    const std::size_t size = column.count * sizeOf (column.type);
    const std::uint8_t* from = column.data.data ();
    std::uint8_t* to = cloud.data.data () + cloud.fields[c].offset;
    for (std::size_t i = 0; i < points; ++i, from += size, to += step) {
      if (!isColorColumn (column)) {
        std::memcpy (to, from, size);
        continue;
      }
      to[color_bytes[3]] = 255;
      for (std::size_t channel = 0; channel < column.count; ++channel)
        to[color_bytes[channel]] = from[channel];
    }
  }
  cloud.is_dense = points == 0 || isDense (CloudFields (cloud));
  return cloud;
}

} // namespace pcl::manifold
