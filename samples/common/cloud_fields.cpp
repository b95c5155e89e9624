#include "cloud_fields.h"

#include <pcl/PCLPointField.h>
#include <pcl/common/io.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <utility>

namespace pcl::manifold::apps {
namespace {

/** \brief Copies a field of every point; both clouds have the same number of points. */
void
copyField (const pcl::PCLPointCloud2& from, const pcl::PCLPointField& source, pcl::PCLPointCloud2& to,
           const pcl::PCLPointField& target)
{
  const std::size_t bytes = fieldBytes (source);
  for (std::size_t row = 0; row < from.height; ++row)
    for (std::size_t column = 0; column < from.width; ++column) {
      const std::size_t begin = row * from.row_step + column * from.point_step + source.offset;
      std::memcpy (&to.data[row * to.row_step + column * to.point_step + target.offset], &from.data[begin],
                   bytes);
    }
}

/** \brief A field of a new cloud, and the one that it is copied from (nullptr: filled later). */
struct NewField
{
  std::string name;
  std::uint8_t datatype;
  std::uint32_t count;
  const pcl::PCLPointField* source;
};

NewField
copyOf (const pcl::PCLPointField& field)
{
  return {field.name, field.datatype, std::max<std::uint32_t> (field.count, 1), &field};
}

/** \brief A cloud of as many points with these fields, packed. */
pcl::PCLPointCloud2
cloudOf (const std::vector<NewField>& fields, const pcl::PCLPointCloud2& cloud)
{
  pcl::PCLPointCloud2 result;
  result.header = cloud.header;
  result.width = cloud.width;
  result.height = cloud.height;
  result.is_bigendian = cloud.is_bigendian;
  result.is_dense = cloud.is_dense;
  for (const NewField& field : fields)
    appendField (result, field.name, field.datatype, field.count);
  allocatePoints (result);
  for (std::size_t i = 0; i < fields.size (); ++i)
    if (fields[i].source != nullptr)
      copyField (cloud, *fields[i].source, result, result.fields[i]);
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

std::uint32_t
fieldBytes (const pcl::PCLPointField& field)
{
  // A count of 0 stands for 1 in the oldest messages.
  return static_cast<std::uint32_t> (pcl::getFieldSize (field.datatype)) *
         std::max<std::uint32_t> (field.count, 1);
}

void
appendField (pcl::PCLPointCloud2& cloud, const std::string& name, std::uint8_t datatype, std::uint32_t count)
{
  pcl::PCLPointField field;
  field.name = name;
  field.datatype = datatype;
  field.count = count;
  field.offset = cloud.point_step;
  cloud.point_step += fieldBytes (field);
  cloud.fields.push_back (field);
}

void
allocatePoints (pcl::PCLPointCloud2& cloud)
{
  cloud.row_step = cloud.point_step * cloud.width;
  cloud.data.resize (static_cast<std::size_t> (cloud.row_step) * cloud.height);
}

pcl::PCLPointCloud2
packed (const pcl::PCLPointCloud2& cloud)
{
  std::vector<NewField> fields;
  for (const pcl::PCLPointField& field : cloud.fields)
    if (field.name != "_")
      fields.push_back (copyOf (field));
  return cloudOf (fields, cloud);
}

template <typename T>
void
setField (pcl::PCLPointCloud2& cloud, const std::string& name, const std::vector<T>& values)
{
  const std::size_t points = static_cast<std::size_t> (cloud.width) * cloud.height;
  if (values.size () != points)
    throw std::invalid_argument ("field '" + name + "' has " + std::to_string (values.size ()) +
                                 " values for " + std::to_string (points) + " points");
  const NewField added{name, pcl::traits::asEnum_v<T>, 1, nullptr};
  std::vector<NewField> fields;
  bool replaced = false;
  for (const pcl::PCLPointField& field : cloud.fields)
    if (field.name != name && field.name != "_")
      fields.push_back (copyOf (field));
    else if (field.name == name && !std::exchange (replaced, true))
      fields.push_back (added);
  if (!replaced)
    fields.push_back (added);
  pcl::PCLPointCloud2 result = cloudOf (fields, cloud);
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

} // namespace pcl::manifold::apps
