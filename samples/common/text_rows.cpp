#include "text_rows.h"

#include "cloud_fields.h"
#include "number_text.h"

#include <pcl/common/io.h>

#include <cstdint>
#include <string_view>

namespace pcl::manifold::apps {
namespace {

/** \brief Where one number of a line goes. */
struct Value
{
  std::string field;
  std::uint32_t offset;
  std::uint8_t datatype;
};

std::vector<Value>
valuesOf (const pcl::PCLPointCloud2& cloud)
{
  std::vector<Value> values;
  for (const pcl::PCLPointField& field : cloud.fields)
    for (std::uint32_t i = 0; i < field.count; ++i)
      values.push_back ({field.name,
                         field.offset + i * static_cast<std::uint32_t> (pcl::getFieldSize (field.datatype)),
                         field.datatype});
  return values;
}

} // namespace

void
readTextRows (InputFile& file, pcl::PCLPointCloud2& cloud, const std::string& what)
{
  allocatePoints (cloud);
  const std::vector<Value> values = valuesOf (cloud);
  const std::uint64_t points = static_cast<std::uint64_t> (cloud.width) * cloud.height;
  std::string line;
  std::vector<std::string_view> words;
  for (std::uint64_t point = 0; point < points;) {
    if (!file.readLine (line))
      file.fail ("truncated: the file ends after line " + std::to_string (file.lineNumber ()) + ", with " +
                 std::to_string (point) + " of " + std::to_string (points) + " lines of " + what);
    splitLine (line, false, words);
    if (words.empty ())
      continue;
    if (words.size () != values.size ())
      file.failAtLine (std::to_string (words.size ()) + " numbers instead of " +
                       std::to_string (values.size ()));
    std::uint8_t* to = cloud.data.data () + point * cloud.point_step;
    for (std::size_t i = 0; i < values.size (); ++i)
      if (!parseField (words[i], values[i].datatype, to + values[i].offset))
        file.failAtLine (quoted (std::string (words[i])) + " is no value for field " +
                         quoted (values[i].field));
    ++point;
  }
}

} // namespace pcl::manifold::apps
