#include "app_files.h"

#include <algorithm>

namespace pcl::manifold::apps {

void
checkWritable (const std::string& file)
{
  about (file, [&] { OutputFile probe (file); });
}

void
writeFile (const std::string& file, std::string_view bytes)
{
  about (file, [&] {
    OutputFile output (file);
    output.write (bytes);
    output.commit ();
  });
}

void
writePcd (const std::string& file, const pcl::PCLPointCloud2& cloud, const Viewpoint& viewpoint)
{
  about (file, [&] {
    OutputFile output (file);
    manifold::writePcd (output, cloud, viewpoint);
    output.commit ();
  });
}

void
requireType (const std::string& argument, const std::string& file, std::initializer_list<std::string> types)
{
  const std::string type = fileType (file);
  if (std::find (types.begin (), types.end (), type) != types.end ())
    return;
  std::string list;
  for (const std::string& known : types)
    list += (list.empty () ? "" : ", ") + known;
  throw UsageError (argument, "'" + file + "' does not end in " + list);
}

} // namespace pcl::manifold::apps
