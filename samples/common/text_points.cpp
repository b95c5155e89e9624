#include "text_points.h"

#include "cloud_fields.h"
#include "number_text.h"

#include <pcl/PCLPointField.h>

#include <cstring>
#include <limits>

namespace pcl::manifold::apps {

bool
parseNumbers (const std::vector<std::string_view>& words, std::vector<double>& numbers)
{
  numbers.resize (words.size ());
  for (std::size_t i = 0; i < words.size (); ++i)
    if (!parseNumber (words[i], numbers[i]))
      return false;
  return !words.empty ();
}

pcl::PCLPointCloud2
cloudOfColumns (const InputFile& file, const std::vector<double>& values, std::size_t columns)
{
  if (values.size () * sizeof (double) > std::numeric_limits<pcl::uindex_t>::max ())
    file.fail (std::to_string (values.size () / columns) + " points of " + std::to_string (columns) +
               " columns are more than PCL can hold");
  pcl::PCLPointCloud2 cloud;
  cloud.height = 1;
  cloud.width = static_cast<pcl::uindex_t> (values.size () / columns);
  for (std::size_t i = 0; i < columns; ++i)
    appendField (cloud, i < 3 ? std::string (1, "xyz"[i]) : "column_" + std::to_string (i + 1),
                 pcl::PCLPointField::FLOAT64);
  allocatePoints (cloud);
  std::memcpy (cloud.data.data (), values.data (), cloud.data.size ());
  return cloud;
}

} // namespace pcl::manifold::apps
