#include "file_type.h"

#include "app_error.h"

#include <algorithm>
#include <filesystem>

namespace pcl::manifold::apps {

std::string
fileType (const std::string& file)
{
  std::string type = std::filesystem::path (file).extension ().string ();
  std::transform (type.begin (), type.end (), type.begin (),
                  [] (char c) { return c >= 'A' && c <= 'Z' ? static_cast<char> (c - 'A' + 'a') : c; });
  return type;
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
