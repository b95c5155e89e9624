#include "complex/files/cloud_fields.h"

#include "complex/files/file_error.h"

#include <pcl/types.h>

#include <cmath>
#include <limits>
#include <set>

namespace pcl {
namespace manifold {

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

} // namespace

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
    // Some of PCL's own readers leave a count of zero where there is one value.
    const std::size_t values = std::max<std::size_t> (field.count, 1);
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
  std::size_t step = 0;
  for (const CloudColumn& column : columns) {
    pcl::PCLPointField field;
    field.name = column.name;
    field.offset = static_cast<pcl::uindex_t> (step);
    field.datatype = column.type;
    field.count = static_cast<pcl::uindex_t> (column.count);
    if (isColorColumn (column)) {
      field.datatype = column.count == 4 ? pcl::PCLPointField::UINT32 : pcl::PCLPointField::FLOAT32;
      field.count = 1;
    }
    step += field.count * sizeOf (field.datatype);
    cloud.fields.push_back (field);
  }
  if (step > std::numeric_limits<pcl::uindex_t>::max ())
    throw FileError ("more bytes a point than a cloud can have");
  cloud.height = 1;
  cloud.width = static_cast<pcl::uindex_t> (points);
  cloud.point_step = static_cast<pcl::uindex_t> (step);
  cloud.row_step = static_cast<pcl::uindex_t> (step * points);
  cloud.data.assign (step * points, 0);
  for (std::size_t c = 0; c < columns.size (); ++c) {
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

} // namespace manifold
} // namespace pcl
